/* SPDX-License-Identifier: MIT */
/** @file glyphs.c
 *  The table of the stroke font. Letters with marks are made of both; those that look alike in several scripts are the same. */
#include "render/canvas.h"

#include <stddef.h>
#include <stdint.h>

/* The characters from '!' to '~'. */
static const char *const ascii[] = {
    "0804 0202",                        /* ! */
    "0806 1816",                        /* " */
    "1218 3238 0444 0646",              /* # */
    "473818070615354443321203 2129",    /* $ */
    "0248 0808 4242",                   /* % */
    "4216172837360403122244",           /* & */
    "0806",                             /* ' */
    "18060412",                         /* ( */
    "08161402",                         /* ) */
    "2327 0446 0644",                   /* * */
    "0545 2327",                        /* + */
    "1201",                             /* , */
    "0535",                             /* - */
    "0202",                             /* . */
    "0149",                             /* / */
    "120307183847433212",               /* 0 */
    "062822 0242",                      /* 1 */
    "07183847460242",                   /* 2 */
    "0718384746354443321203 3515",      /* 3 */
    "32380444",                         /* 4 */
    "480805354443321203",               /* 5 */
    "4738180703123243443505",           /* 6 */
    "084812",                           /* 7 */
    "15354443321203041506071838474635", /* 8 */
    "0312324347381807061545",           /* 9 */
    "0202 0505",                        /* : */
    "1515 1201",                        /* ; */
    "380532",                           /* < */
    "0444 0646",                        /* = */
    "083502",                           /* > */
    "07183847462524 2222",              /* ? */
    "120307183847433212 2525",          /* @ */
    "022842 1434",                      /* A */
    "02083847463505 3544433202",        /* B */
    "4738180703123243",                 /* C */
    "02082846442202",                   /* D */
    "48080242 0535",                    /* E */
    "480802 0535",                      /* F */
    "47381807031232434525",             /* G */
    "0208 4248 0545",                   /* H */
    "0208",                             /* I */
    "4843321203",                       /* J */
    "0208 4804 1542",                   /* K */
    "080242",                           /* L */
    "0208254842",                       /* M */
    "02084248",                         /* N */
    "120307183847433212",               /* O */
    "02083847463505",                   /* P */
    "120307183847433212 2442",          /* Q */
    "02083847463505 2542",              /* R */
    "473818070615354443321203",         /* S */
    "0848 2228",                        /* T */
    "080312324348",                     /* U */
    "082248",                           /* V */
    "0812253248",                       /* W */
    "0248 0842",                        /* X */
    "082548 2522",                      /* Y */
    "08480242",                         /* Z */
    "18080212",                         /* [ */
    "0941",                             /* backslash */
    "08181202",                         /* ] */
    "062846",                           /* ^ */
    "0141",                             /* _ */
    "0817",                             /* ` */
    "3526160503122233 3632",            /* a */
    "0208 0516263533221203",            /* b */
    "3526160503122233",                 /* c */
    "3832 3526160503122233",            /* d */
    "04343526160503122233",             /* e */
    "281712 0626",                      /* f */
    "3526160503122233 3631201001",      /* g */
    "0208 0516263532",                  /* h */
    "0206 0808",                        /* i */
    "161100 1818",                      /* j */
    "0208 3603 1432",                   /* k */
    "080312",                           /* l */
    "0206 05162522 25364542",           /* m */
    "0206 0516263532",                  /* n */
    "120305162635332212",               /* o */
    "0006 0516263533221203",            /* p */
    "3630 3526160503122233",            /* q */
    "0206 051626",                      /* r */
    "3616051424332202",                 /* s */
    "181322 0626",                      /* t */
    "0603122233 3632",                  /* u */
    "062246",                           /* v */
    "0612253246",                       /* w */
    "0632 0236",                        /* x */
    "0622 4610",                        /* y */
    "06360232",                         /* z */
    "2817160514131222",                 /* { */
    "0109",                             /* | */
    "0817162514131202",                 /* } */
    "05163445",                         /* ~ */
};

/* Letters, and the ASCII characters that look like them. */
static const char alike[] = "АВЕКМНОРСТХІЈЅЗаеосрхуіјѕΑΒΕΖΗΙΚΜΝΟΡΤΥΧοѵ";
static const char alike_ascii[] = "ABEKMHOPCTXIJS3aeocpxyijsABEZHIKMNOPTYXov";

/* Other characters; those of one text look alike. */
static const struct {
    const char *characters, *strokes;
} others[] = {
    {"Æ", "022858 383252 1434 3545"},
    {"æ", "051625231203145455463625 23324253"},
    {"Œ", "581807031252 3832 3545"},
    {"œ", "1203051625231203 245455463625 23324253"},
    {"Ø", "120307183847433212 0149"},
    {"ø", "120305162635332212 0137"},
    {"ÐĐ", "02082846442202 0525"},
    {"ð", "120305162635332212 2718 0738"},
    {"đ", "3832 3526160503122233 2747"},
    {"Þ", "0802 073746453404"},
    {"þ", "0008 0516263533221203"},
    {"Ł", "080242 0427"},
    {"ł", "181322 0426"},
    {"ß", "0207182837362534332212"},
    {"Ħ", "0208 4248 0545 0747"},
    {"ħ", "0208 0516263532 0727"},
    {"Ŋ", "0208 073748424131"},
    {"ŋ", "0206 051626353120"},
    {"ı", "0206"},
    {"ȷ", "161100"},
    {"ГΓ", "480802"},
    {"Д", "01024241 12283832"},
    {"Ж", "0248 0842 2228"},
    {"И", "08024842"},
    {"Л", "0212284842"},
    {"ПΠ", "02084842"},
    {"У", "0825 481202"},
    {"ФΦ", "173746453414050617 2228"},
    {"Ц", "08024241 3832"},
    {"Ч", "08061545 4842"},
    {"Ш", "08024248 2228"},
    {"Щ", "08025251 2228 4248"},
    {"Ъ", "0818123243443515"},
    {"Ы", "08022233342505 5852"},
    {"Ь", "08023243443505"},
    {"Э", "0718384743321203 2545"},
    {"Ю", "0208 0525 322327384857534232"},
    {"Я", "42481807061545 2502"},
    {"Є", "4738180703123243 0535"},
    {"Ґ", "49480802"},
    {"Ђ", "0848 1812 1535444231"},
    {"Ћ", "0848 1812 15354442"},
    {"Љ", "02122838324253544535"},
    {"Њ", "0208 0535 38324253544535"},
    {"Џ", "08024248 2221"},
    {"б", "4918060312324344351504"},
    {"в", "020636453404 34433202"},
    {"г", "360602"},
    {"д", "01024241 12263632"},
    {"ж", "0246 0642 2226"},
    {"з", "0636453414 34433202"},
    {"и", "06024642"},
    {"кκ", "0206 360432"},
    {"л", "0212264642"},
    {"м", "0206244642"},
    {"н", "0206 4642 0444"},
    {"п", "02064642"},
    {"т", "0646 2622"},
    {"фφϕ", "120305163645433212 2028"},
    {"ц", "06024241 3632"},
    {"ч", "06051444 4642"},
    {"ш", "06024246 2226"},
    {"щ", "06025251 2226 4246"},
    {"ъ", "06161232433414"},
    {"ы", "060222332404 5652"},
    {"ь", "060232433404"},
    {"э", "0516364543321203 2444"},
    {"ю", "0206 0424 322325364655534232"},
    {"я", "424616051444 2402"},
    {"є", "4536160503123243 0434"},
    {"ґ", "37360602"},
    {"ђ", "1812 0737 152636454130"},
    {"ћ", "1812 0737 1526364542"},
    {"љ", "021226363242534434"},
    {"њ", "0206 0434 363242534434"},
    {"џ", "06024246 2221"},
    {"Δ", "02284202"},
    {"Θ", "120307183847433212 1535"},
    {"Λ", "022842"},
    {"Ξ", "0848 1535 0242"},
    {"Σ", "4808250242"},
    {"Ψ", "080615354648 2228"},
    {"Ω", "021213050718384745333242"},
    {"α", "46332212030516263342"},
    {"β", "0007182837362515 2544433212"},
    {"γ", "062246 2220"},
    {"δ", "4818174443321203041525"},
    {"ε", "453616051403123243 1434"},
    {"ζ", "0848040312323120"},
    {"η", "0206 0516263530"},
    {"θϑ", "120307182837332212 0535"},
    {"ι", "060312"},
    {"λ", "081842 2602"},
    {"μµ", "0006 03122233 3632"},
    {"ν", "062246"},
    {"ξ", "3818071636 16050312323120"},
    {"π", "0646 1612 3632"},
    {"ρ", "000516263533221203"},
    {"ς", "453616050312323120"},
    {"σ", "461605031222333526"},
    {"τ", "0646 262332"},
    {"υ", "060312223336"},
    {"χ", "0640 4600"},
    {"ψ", "060413334446 2620"},
    {"ω", "160503122324 2332434536"},
    {"°", "1807162718"},
    {"±", "0545 2723 0242"},
    {"²", "0819280525"},
    {"³", "092917261505"},
    {"·", "0505"},
    {"×", "0336 0633"},
    {"÷", "0545 2727 2323"},
    {"«", "261422 463442"},
    {"»", "062402 264422"},
    {"–−", "0535"},
    {"—", "0555"},
    {"…", "0202 2222 4242"},
    {"’‘", "0806"},
    {"“”„", "0806 1816"},
    {"€", "4738180703123243 0626 0424"},
    {"Б", "4808023243443505"},
};

/* Marks over letters of the x-height, or under their baseline, about x = 2; letters that have them, and these without. */
static const struct {
    const char *strokes, *marked, *plain;
} marks[] = {
    {"1927", "ÀàÈèÌìÒòÙùǸǹ", "AaEeIıOoUuNn"},
    {"3927", "ÁáÉéÍíÓóÚúÝýĆćĹĺŃńŔŕŚśŹźЃѓЌќάΆέΈήΉίΊόΌύΎώΏ", "AaEeIıOoUuYyCcLlNnRrSsZzГгКкαΑεΕηΗιΙοΟυΥωΩ"},
    {"172937", "ÂâÊêÎîÔôÛûĈĉĜĝĤĥĴĵŜŝŴŵŶŷ", "AaEeIıOoUuCcGgHhJȷSsWwYy"},
    {"192739", "ČčĎďĚěŇňŘřŠšŤťŽžĽľ", "CcDdEeNnRrSsTtZzLl"},
    {"07183748", "ÃãÑñÕõĨĩŨũ", "AaNnOoIıUu"},
    {"1818 3838", "ÄäËëÏïÖöÜüŸÿЁёЇїΪϊΫϋ", "AaEeIıOoUuYyЕеIıΙιΥυ"},
    {"1818 3838 2729", "ΐΰ", "ιυ"},
    {"2918273829", "ÅåŮů", "AaUu"},
    {"1729 3749", "ŐőŰű", "OoUu"},
    {"2828", "ĊċĖėĠġİŻż", "CcEeGgIZz"},
    {"1838", "ĀāĒēĪīŌōŪū", "AaEeIıOoUu"},
    {"1918283839", "ĂăĔĕĞğĬĭŎŏŬŭЙйЎў", "AaEeGgIıOoUuИиУy"},
    {"2221313010", "ÇçŞşŢţ", "CcSsTt"},
    {"32213040", "ĄąĘęĮįŲų", "AaEeIiUu"},
    {"2110", "ĢĶķĻļŅņŖŗȘșȚț", "GKkLlNnRrSsTt"},
};

enum { MIDDLE = 2, BASELINE = 2, X_HEIGHT = 6, CAP_HEIGHT = 8 };

static const char unknown[] = "0208484202";

/* ---- UTF-8 ------------------------------------------------------------------------------------------------------- */

/* What is no character: a byte that is none, and the beginning of one. */
enum { WRONG = 0xFFFD, CUT = 0 };

static uint32_t next_character(const char **text)
{
    const unsigned char *at = (const unsigned char *)*text;
    const uint32_t first = *at;
    const int more = first < 0x80 ? 0 : first < 0xC2 ? -1 : first < 0xE0 ? 1 : first < 0xF0 ? 2 : first < 0xF5 ? 3 : -1;
    uint32_t code = more <= 0 ? first : first & (0x3FU >> more);
    ++*text;
    if (more < 0)
        return WRONG;
    for (int k = 1; k <= more; ++k, ++*text) {
        if ((at[k] & 0xC0) != 0x80)
            return CUT;
        code = code << 6 | (at[k] & 0x3FU);
    }
    return code;
}

/* The place of a character in a text; -1 if it has none of it. */
static int place_in(const char *text, uint32_t character)
{
    for (int place = 0; *text != '\0'; ++place)
        if (next_character(&text) == character)
            return place;
    return -1;
}

static uint32_t character_at(const char *text, int place)
{
    while (place-- > 0)
        next_character(&text);
    return next_character(&text);
}

/* ---- glyphs ------------------------------------------------------------------------------------------------------ */

/* Strokes of a character without a mark; NULL if it has none. */
static const char *strokes_of(uint32_t character)
{
    if (character >= 0x80) {
        const int place = place_in(alike, character);
        if (place >= 0)
            character = (unsigned char)alike_ascii[place];
    }
    if (character - '!' < sizeof ascii / sizeof ascii[0])
        return ascii[character - '!'];
    for (size_t i = 0; i < sizeof others / sizeof others[0]; ++i)
        if (place_in(others[i].characters, character) >= 0)
            return others[i].strokes;
    return NULL;
}

/* The largest and smallest of one coordinate of strokes: 0 for x, 1 for y. */
static void find_extent(const char *strokes, int coordinate, int *low, int *high)
{
    *low = 9;
    *high = 0;
    for (const char *at = strokes; *at != '\0'; at += *at == ' ' ? 1 : 2) {
        const int value = *at == ' ' ? -1 : at[coordinate] - '0';
        if (value > *high)
            *high = value;
        if (value >= 0 && value < *low)
            *low = value;
    }
}

/* Puts a mark over or under the middle of a glyph, over a capital or an ascender higher. */
static void add_mark(sph2d__glyph *glyph, const char *mark)
{
    int left, right, low, high, mark_low, mark_high;
    find_extent(mark, 0, &left, &right);
    find_extent(mark, 1, &mark_low, &mark_high);
    find_extent(glyph->strokes, 1, &low, &high);
    const double wide = glyph->width > right - left ? glyph->width : right - left;
    glyph->mark = mark;
    glyph->x = (wide - glyph->width) / 2;
    glyph->mark_x = wide / 2 - MIDDLE;
    glyph->mark_y = mark_low > BASELINE && high > X_HEIGHT ? CAP_HEIGHT - X_HEIGHT : 0;
    glyph->width = wide;
}

sph2d__glyph sph2d__glyph_next(const char **text)
{
    uint32_t character = next_character(text);
    const char *mark = NULL;
    for (size_t i = 0; character >= 0x80 && !mark && i < sizeof marks / sizeof marks[0]; ++i) {
        const int place = place_in(marks[i].marked, character);
        if (place < 0)
            continue;
        mark = marks[i].strokes;
        character = character_at(marks[i].plain, place);
    }
    if (character == CUT)
        return (sph2d__glyph){NULL};
    const char *strokes = strokes_of(character);
    sph2d__glyph glyph = {.strokes = strokes ? strokes : unknown};
    int left, right;
    find_extent(glyph.strokes, 0, &left, &right);
    glyph.width = right;
    if (mark)
        add_mark(&glyph, mark);
    return glyph;
}
