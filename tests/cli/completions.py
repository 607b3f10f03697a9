# SPDX-License-Identifier: MIT
"""Completes command lines in every shell that is installed: completions.py FOLDER_OF_COMPLETIONS. The current folder has
the files of completions.sh."""
import os
import re
import shutil
import subprocess
import sys
import time

from terminal import Shell

BASH_COMPLETION = "/usr/share/bash-completion/bash_completion"
SCENES = {"tank.yaml", "scene.yaml", "data.json", "my scene.yaml", "it's.yaml", "a=b:c.yml", "bäche.yaml"}

# How many of the lines below, the first, are about names of files, which settings of a shell may change.
FILES = 16

# What is typed, and what comes of it; None: nothing is promised, but what comes after works.
LINES = [
    ("sph2d ru\t", "sph2d run "),  # and not the folder of that name
    ("sph2d run sce\t", "sph2d run scene.yaml "),
    ("sph2d check da\t", "sph2d check data.json "),
    ("sph2d study a\t", "sph2d study a=b:c.yml "),
    ("sph2d run a=\t", "sph2d run a=b:c.yml "),
    ("sph2d run a=b:\t", "sph2d run a=b:c.yml "),
    ("sph2d run my\t", r"sph2d run my\ scene.yaml "),
    (r"sph2d run my\ s" + "\t", r"sph2d run my\ scene.yaml "),
    ('sph2d run "my\t', 'sph2d run "my scene.yaml" '),
    ("sph2d run 'my s\t", "sph2d run 'my scene.yaml' "),
    ("sph2d run it\t", r"sph2d run it\'s.yaml "),
    ("sph2d run b\t", "sph2d run bäche.yaml "),
    ("sph2d run fold\t", "sph2d run folder/"),
    ("sph2d run folder/d\t", "sph2d run folder/deep.yaml "),
    ("sph2d run ~/at\t", "sph2d run ~/at_home.yaml "),
    ("sph2d run $HOME/at\t", None),  # nothing wrong happens
    ("sph2d run scene.yaml d\t", "sph2d run scene.yaml d"),  # it has its scene
    ("sph2d run -s spacing=0.1 sce\t", "sph2d run -s spacing=0.1 scene.yaml "),
    ("sph2d run --set spacing=0.1 --isa=avx2 sce\t", "sph2d run --set spacing=0.1 --isa=avx2 scene.yaml "),
    ("sph2d run -- sce\t", "sph2d run -- scene.yaml "),
    ("sph2d run -q sce\t", "sph2d run -q scene.yaml "),
    ("sph2d run -o fo\t", "sph2d run -o folder/"),
    ("sph2d run -o tw\t", r"sph2d run -o two\ words/"),
    ("sph2d run --output=fo\t", "sph2d run --output=folder/"),
    ("sph2d resume fol\t", "sph2d resume folder/"),
    ("sph2d resume folder/\t", "sph2d resume folder/inner/"),
    ("sph2d plot fol\t", "sph2d plot folder/"),
    ("sph2d plot -o pic\t", "sph2d plot -o picture.png "),
    ("sph2d plot folder fo\t", "sph2d plot folder fo"),
    ("sph2d export snap\t", "sph2d export snapshot_000000.h5 "),
    ("sph2d info snap\t", "sph2d info snapshot_000000.h5 "),
    ("sph2d info snapshot_000000.h5 fo\t", "sph2d info snapshot_000000.h5 folder/"),
    ("sph2d render snap\t", "sph2d render snapshot_000000.h5 "),
    ("sph2d check scene.yaml --preview pic\t", "sph2d check scene.yaml --preview picture.png "),
    ("sph2d run --isa av\t512\t", "sph2d run --isa avx512 "),
    ("sph2d run --isa=base\t", "sph2d run --isa=baseline "),
    ("sph2d run --progress ne\t", "sph2d run --progress never "),
    ("sph2d render --style=po\t", "sph2d render --style=points "),
    ("sph2d init --template dr\t", "sph2d init --template drop "),
    # keys, with the items that the lists of the scene have, and values
    ("sph2d run -s spac\t", "sph2d run -s spacing="),
    ("sph2d run --set=spac\t", "sph2d run --set=spacing="),
    ("sph2d run -s flu\t", "sph2d run -s fluid"),
    ("sph2d run -s fluid.den\t", "sph2d run -s fluid.density="),
    ("sph2d run -s run.fr\t", "sph2d run -s run.frames."),
    ("sph2d run -s fluid.material=hon\t", "sph2d run -s fluid.material=honey "),
    ("sph2d run -s fluid=merc\t", "sph2d run -s fluid=mercury "),
    ("sph2d run --set=method.operators=f\t", "sph2d run --set=method.operators=fitted "),
    ("sph2d run -s spacing=0\t", "sph2d run -s spacing=0"),
    ("sph2d run -s xyzzy=\t", None),
    ("sph2d run tank.yaml -s blocks[1].cir\t", "sph2d run tank.yaml -s blocks[1].circle."),
    ("sph2d run tank.yaml -s blocks[1].bo\t", "sph2d run tank.yaml -s blocks[1].bo"),  # it is a circle
    ("sph2d run tank.yaml -s blocks[2].v\t", "sph2d run tank.yaml -s blocks[2].v"),  # there is none
    ("sph2d run -s spacing=0.1 tank.yaml -s obstacles[0].liquid=bo\t",
     "sph2d run -s spacing=0.1 tank.yaml -s obstacles[0].liquid=both "),
    ("sph2d run -s blocks[1].ci tank.yaml" + 10 * "\x02" + "\t", "sph2d run -s blocks[1].circle. tank.yaml"),
    ("sph2d resume folder -s run.\t", "sph2d resume folder -s run.until="),
    ("sph2d render tank.yaml --follow ga\t", "sph2d render tank.yaml --follow gate "),
    ("sph2d plot folder en\t", "sph2d plot folder energy "),
    ("sph2d plot folder energy ga\t", "sph2d plot folder energy gauge "),
    ("sph2d help mat\t", "sph2d help materials "),
    ("sph2d help inf\t", "sph2d help info "),
    ("sph2d help scene.m\t", "sph2d help scene.m"),
    ("sph2d --vers\t", "sph2d --version "),
    ("sph2d xyzzy sce\t", None),
    ("{path} run sce\t", "{path} run scene.yaml "),
]


def told(*arguments):
    """What the command prints, on whichever stream."""
    result = subprocess.run(["sph2d", *arguments], capture_output=True, text=True, check=False)
    return result.stdout + result.stderr


def table():
    """Commands with their operands and options, from `sph2d help completions`, and topics."""
    commands, topics = {}, set()
    for line in told("help", "completions").splitlines():
        kind, name, *rest = line.split("\t")
        if kind == "command":
            commands[name] = (rest[0], {})
        elif kind == "option":
            letter, long, argument, words, _ = rest
            commands[name][1][long] = (letter, argument, set() if words == "-" else set(words.split()))
        else:
            topics.add(name)
    return commands, topics


def check_table(commands, topics):
    """The table against help, and the words against what the parser takes and says."""
    shown = set(re.findall(r"^  (\w+) ", told("help"), re.M))
    shown_keys = {line.split(":")[0].split()[0] for line in told("help", "scene").splitlines() if line[0] not in " -"}
    paths = {line.split("\t")[1] for line in told("help", "completions", "").splitlines()}
    assert {re.split(r"[.[]", path)[0] for path in paths} == shown_keys, shown_keys
    assert set(commands) == shown, (set(commands), shown)
    listed = set(re.findall(r"or: ([\w., ]+)$", told("help"), re.M)[0].split(", "))
    assert topics == listed, (topics, listed)
    for name, (_, options) in commands.items():
        longs = set(re.findall(r"^  (?:-\w,|   ) (--[a-z-]+)", told(name, "--help"), re.M))
        assert longs == set(options), (name, longs ^ set(options))
        for long, (letter, argument, words) in options.items():
            if long == "--device":  # and numbers
                assert words == {"cpu", "gpu"}, words
            elif words and long != "--template":
                said = re.search(r"'\?' is not (.*)", told(name, "x", f"{long}=?")).group(1)
                assert set(re.split(", | or ", said)) == words, (long, said, words)
            if long == "--template":
                section = told(name, "--help").split("templates:\n")[1].split("\n\n")[0]
                assert set(re.findall(r"^  (\w+)", section, re.M)) == words, words
            if letter != "-":
                assert f"  {letter}, {long}" in told(name, "--help"), letter
            assert bool(words) <= (argument != "-"), long


def check_lines(shell, kind, lines):
    path = os.path.relpath(shutil.which("sph2d"))
    for keys, wanted in lines:
        # Whether = and : are quoted, and brackets, depends on where the shell splits words.
        got = re.sub(r"\\([][=:])", r"\1", shell.complete(keys.replace("{path}", path)))
        assert wanted is None or got == wanted.replace("{path}", path), (kind, keys, got, wanted)


def check_offers(shell, kind, commands, topics):
    """Everything that is offered where nothing is typed yet."""
    offered = shell.everything("sph2d ") - {"--help", "--version"}
    assert offered == set(commands), (kind, offered)
    assert shell.everything("sph2d help ") == topics | set(commands), kind
    known = {line.split("\t")[1] for line in told("help", "completions", "").splitlines() if line.startswith("key\t")}
    firsts = {key.split(".")[0] + "." if "." in key else key + "=" for key in known}
    offered = {word.replace("\\", "") for word in shell.everything("sph2d run -s ")}
    assert offered == firsts and len(firsts) > 30, (kind, offered ^ firsts)
    offered = shell.everything("sph2d run -s walls=")
    assert {word.split("=")[-1] for word in offered} == {"default", "spring", "heavy", "reflect", "generalised"}, (kind, offered)
    known = set()
    for name, (operands, options) in commands.items():
        offered = {word.rstrip("=") for word in shell.everything(f"sph2d {name} --")}
        assert offered == set(options), (kind, name, offered ^ set(options))
        for long, (letter, argument, words) in options.items():
            for option in {long, letter} - {"-"}:
                if words and option not in known:
                    known.add(option)
                    assert shell.everything(f"sph2d {name} {option} ") == words, (kind, name, option)
        # What a command takes is known to the completion; a name that the user chooses is not.
        if operands not in ("-", "NAME"):
            line = shell.complete(f"sph2d {name} \x18a").replace("\\", "")
            some = {"SCENE": SCENES, "STUDY": SCENES}.get(operands.split()[0], {"folder"} if "DIR" in operands else set())
            assert len(line) > len(f"sph2d {name} "), (kind, name, operands)
            assert all(file in line for file in some), (kind, name, line)
            assert kind == "zsh" or "notes.txt" not in line, (kind, name, line)


def shells(folder):
    """The shells that there are: a title, the kind, its settings and environment. The first of a kind is asked for all."""
    yield "bash", "bash", f". {folder}/sph2d.bash\n", {}
    yield "bash with failglob", "bash", f"shopt -s failglob nullglob extglob\n. {folder}/sph2d.bash\n", {}
    yield "bash, words whole", "bash", f"COMP_WORDBREAKS=${{COMP_WORDBREAKS//[:=]}}\n. {folder}/sph2d.bash\n", {}
    if os.path.exists(BASH_COMPLETION):
        os.makedirs("../user/completions", exist_ok=True)
        shutil.copy(f"{folder}/sph2d.bash", "../user/completions/sph2d")
        yield "bash-completion", "bash", f". {BASH_COMPLETION}\n", {"BASH_COMPLETION_USER_DIR": os.path.abspath("../user")}
    if shutil.which("zsh"):
        yield "zsh", "zsh", f"fpath=({folder} $fpath)\nautoload -Uz compinit && compinit -D -u\n", {}


def main():
    commands, topics = table()
    check_table(commands, topics)
    asked = set()
    for title, kind, setup, environment in shells(sys.argv[1]):
        begun = time.monotonic()
        shell = Shell(kind, "..", setup, environment)
        check_lines(shell, kind, LINES if kind not in asked or "completion" in title else LINES[:FILES])
        if kind not in asked:
            check_offers(shell, kind, commands, topics)
        asked.add(kind)
        shell.close()
        print(f"completions: {title} ({time.monotonic() - begun:.1f} s)")


main()
