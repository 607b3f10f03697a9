# sph2d: build, tests, installation. `make help` lists the targets; needs GNU make 4.2 or newer.

MAKEFLAGS += --no-builtin-rules --no-print-directory
.SUFFIXES:
.DELETE_ON_ERROR:
.DEFAULT_GOAL := all

# ---- what can be set from outside ------------------------------------------------------------------------------------
BUILD ?= build
OPENMP ?= 1
RENDER ?= 1
# Whether the command uses the shared libraries, for packages; else it is whole by itself.
SHARED ?= 0
PREFIX ?= /usr/local
prefix ?= $(PREFIX)
bindir ?= $(prefix)/bin
libdir ?= $(prefix)/lib
includedir ?= $(prefix)/include
datadir ?= $(prefix)/share
mandir ?= $(datadir)/man
docdir ?= $(datadir)/doc/sph2d
bashcompletiondir ?= $(datadir)/bash-completion/completions
zshcompletiondir ?= $(datadir)/zsh/site-functions
pkgconfigdir ?= $(libdir)/pkgconfig
cmakedir ?= $(libdir)/cmake/sph2d
# Where the first Python looks for modules below the prefix. The package of NumPy is for that of the system alone.
PYTHONS := $(or $(PYTHON),python3 /usr/bin/python3)
python_folders = import sys; [print(d) for d in sys.path if d.startswith("$(prefix)/lib") and d.endswith("-packages")]
pythondir ?= $(or $(firstword $(shell for p in $(PYTHONS); do "$$p" -I -c '$(python_folders)' 2>/dev/null; done)), \
    $(prefix)/lib/python3/dist-packages)
INSTALL ?= install
ifneq ($(findstring ',$(CURDIR)$(BUILD)$(DESTDIR)$(prefix)),)
$(error sph2d: a path has an apostrophe ('), which the commands here quote paths by: use a folder without one)
endif
PKG_CONFIG ?= pkg-config
# How many times as long the limits of time of tests are, for a busy machine.
CK_TIMEOUT_MULTIPLIER ?= 1
# also: CC AR CPPFLAGS CFLAGS LDFLAGS LDLIBS DESTDIR PYTHON; WERROR=1 SANITIZE=address,undefined V=1 DEPS=skip

# pkg-config name = Debian package. EGL needs a driver at run time, which its package only hints at.
PACKAGES := hdf5=libhdf5-dev libfyaml=libfyaml-dev expat=libexpat1-dev libxxhash=libxxhash-dev check=check $(if $(filter-out 0,$(RENDER)), \
    libpng=libpng-dev osmesa=libosmesa6-dev egl=libegl-dev+libgl1-mesa-dri glfw3=libglfw3-dev)
# Those that pkg-config does not know: header = Debian package.
HEADER_PACKAGES := chipmunk/chipmunk.h=libchipmunk-dev

# ---- first reading, for the goals that set up the machine ------------------------------------------------------------
# They install what is missing before flags are asked of pkg-config; the work is done by a second reading of this file.
ifneq ($(if $(PACKAGES_CHECKED),,$(filter demo test test-full test-variants check-lint test-ports test-sanitize test-fuzz coverage report report-full test-slurm web test-web,$(MAKECMDGOALS))),)

# All processors, unless told otherwise or told to clean first.
jobs = $(if $(or $(findstring -j,$(MAKEFLAGS)),$(filter clean,$(MAKECMDGOALS))),,-j"$$(nproc)")
.PHONY: set-up-first $(MAKECMDGOALS)
$(MAKECMDGOALS): set-up-first
	@:
set-up-first:
	@$(if $(filter skip,$(DEPS)),:,CC='$(CC)' PKG_CONFIG='$(PKG_CONFIG)' OPENMP='$(OPENMP)' RENDER='$(RENDER)' PYTHONS='$(PYTHONS)' \
	    CHROMIUM='$(CHROMIUM)' BUILD='$(BUILD)' PACKAGES='$(PACKAGES)' HEADER_PACKAGES='$(HEADER_PACKAGES)' \
	    .ci/packages.sh $(MAKECMDGOALS))
	@$(MAKE) $(jobs) PACKAGES_CHECKED=1 $(MAKECMDGOALS)

else
# ---- tools and packages ----------------------------------------------------------------------------------------------
COMPILER := $(shell $(CC) --version 2>/dev/null | head -n 1)
MACHINE := $(shell $(CC) -dumpmachine 2>/dev/null)
CLANG := $(findstring clang,$(COMPILER))
WITH_OPENMP := $(filter-out 0,$(OPENMP))
WITH_RENDER := $(filter-out 0,$(RENDER))
WITH_SHARED := $(filter-out 0,$(SHARED))

# Foreign headers are system headers: their warnings are not ours.
pc_cflags = $(patsubst -I%,-isystem %,$(if $(1),$(shell $(PKG_CONFIG) --cflags $(1) 2>/dev/null)))
pc_libs = $(if $(1),$(shell $(PKG_CONFIG) --libs $(1) 2>/dev/null))
HASH := \#
FOUND := $(shell for p in hdf5 libfyaml expat libxxhash libpng osmesa egl glfw3 check; do \
    $(PKG_CONFIG) --exists $$p 2>/dev/null && echo $$p; done; for h in $(HEADER_PACKAGES); do \
    echo "$(HASH)include <$${h%%=*}>" | $(CC) -E - >/dev/null 2>&1 && echo $${h%%=*}; done)
GL := $(if $(WITH_RENDER),$(filter osmesa egl,$(FOUND)))
# The window of `sph2d play`; without it the command says what to install.
GLFW := $(if $(WITH_RENDER),$(filter glfw3,$(FOUND)))
MISSING := $(filter-out $(FOUND),hdf5 libfyaml expat libxxhash chipmunk/chipmunk.h $(if $(WITH_RENDER),libpng $(if $(GL),,osmesa egl)))

# ---- flags: the project's own, then whatever comes from outside ------------------------------------------------------
# OpenMP shares the loops. Without it its pragmas vanish, and with them the only use of some variables.
OMP_CFLAGS := $(if $(WITH_OPENMP),-fopenmp,-Wno-unknown-pragmas -Wno-unused-variable -Wno-unused-parameter)
# Messages are cut at their capacity by contract, and clang's "not vectorised" is no fault, nor are the conversions that
# it makes itself for a taskloop.
WARNINGS := -Wall -Wextra -Wpedantic -Wshadow -Wundef -Wvla -Wformat=2 -Wno-format-nonliteral -Wstrict-prototypes \
    -Wmissing-prototypes -Wold-style-definition -Wpointer-arith -Werror=switch -Wwrite-strings -Wcast-qual \
    -Wconversion -Wsign-conversion \
    $(if $(CLANG),-Wno-pass-failed -Wno-sign-conversion -Wno-sign-compare -Wno-shorten-64-to-32,-Wno-format-truncation) $(if $(filter 1,$(WERROR)),-Werror)
SANITIZERS := $(if $(SANITIZE),-fsanitize=$(SANITIZE) -fno-sanitize-recover=all -fno-omit-frame-pointer)
# On 32-bit x86 arithmetic is that of SSE2: the stack of the 8087 rounds where it stores, and has no vectors.
X87_CFLAGS := $(if $(filter i386-% i486-% i586-% i686-%,$(MACHINE)), -msse2 -mfpmath=sse)
# One position-independent object serves both the archive and the shared library. Contraction is off so that a fused
# multiply-add stands only where it was written; interposition is off so that exported functions can still be inlined.
ALL_CFLAGS := -std=c17 $(if $(SANITIZE),-O2 -g,-O3) $(WARNINGS) -fno-math-errno -ffp-contract=off -fPIC \
    -fvisibility=hidden -fno-semantic-interposition $(OMP_CFLAGS) $(SANITIZERS)$(X87_CFLAGS)
HERE_CFLAGS := -ffile-prefix-map='$(CURDIR)'=. # no object names the folder that it was built in
ALL_CPPFLAGS := -D_POSIX_C_SOURCE=200809L -MMD -MP
ALL_LDFLAGS := -Wl,--as-needed -pthread $(if $(WITH_OPENMP),-fopenmp) $(SANITIZERS) $(LDFLAGS)
SHARED_LDFLAGS := -shared -Wl,--version-script=src/libsph2d.map $(if $(SANITIZE),,-Wl,--no-undefined)

comma := ,
X86 := $(filter x86_64-% amd64-%,$(MACHINE))
ISAS := baseline $(if $(X86),avx2 avx512)
# On Windows gcc keeps the stack aligned to 16 bytes only (its bug 54412): wide vectors there are moved as unaligned ones.
UNALIGNED := $(if $(findstring mingw,$(MACHINE)),$(if $(CLANG),,-Wa$(comma)-muse-unaligned-vector-move))
ISA_FLAGS_avx2 := -mavx2 -mfma $(UNALIGNED)
ISA_FLAGS_avx512 := -mavx512f -mavx512dq -mavx512vl -mprefer-vector-width=512 $(UNALIGNED)

CORE_FLAGS := -Iinclude -Isrc $(if $(X86),-DSPH2D__ISA_X86)
IO_FLAGS := -Iinclude -Isrc $(call pc_cflags,hdf5 libfyaml expat libxxhash)
CONTACTS_FLAGS := -Iinclude -Isrc
RENDER_FLAGS := -Iinclude -Isrc -I$(BUILD)/gen $(call pc_cflags,libpng $(GL)) \
    $(if $(filter osmesa,$(GL)),-DSPH2D_HAVE_OSMESA) $(if $(filter egl,$(GL)),-DSPH2D_HAVE_EGL)
CLI_FLAGS := -Iinclude -Icli -I$(BUILD)/gen $(if $(WITH_RENDER),,-DSPH2D_NO_RENDER) \
    $(call pc_cflags,$(GLFW))
TEST_FLAGS := -Itests $(CORE_FLAGS) $(call pc_cflags,check hdf5 libxxhash $(if $(WITH_RENDER),libpng)) \
    $(if $(WITH_RENDER),-I$(BUILD)/gen,-DSPH2D_NO_RENDER)

CORE_LIBS := -lm
IO_LIBS := $(call pc_libs,hdf5 libfyaml expat) -lm
CONTACTS_LIBS := -lchipmunk -lm
RENDER_LIBS := $(if $(WITH_RENDER),$(call pc_libs,libpng $(GL)) -lz -lm)

# ---- sources and objects ---------------------------------------------------------------------------------------------
VERSION := $(shell sed -n 's/^\#define SPH2D_VERSION "\(.*\)"/\1/p' include/sph2d/version.h)
SOMAJOR := 0
# A folder uses only those before it; the methods do not know each other.
CORE_DIRS := base device simd kernels forces scene particles flows boundary methods/common methods/terms sim start probes \
    methods/muller methods/wcsph methods/fitted methods/projection methods/hybrid methods run
CORE_SRC := $(sort $(foreach d,$(CORE_DIRS),$(wildcard src/$(d)/*.c)))
PASS_SRC := $(filter %_pass.c,$(CORE_SRC))
IO_SRC := $(sort $(wildcard src/files/*.c))
STUDY_SRC := $(sort $(wildcard src/study/*.c))
CONTACTS_SRC := $(sort $(wildcard src/contacts/*.c))
OTHER_GL := $(filter-out $(GL),osmesa egl)
RENDER_SRC := $(filter-out $(OTHER_GL:%=src/render/gl_context_%.c),$(sort $(wildcard src/render/*.c)))
PLAY_SRC := $(if $(GLFW),$(filter-out cli/play/none.c,$(wildcard cli/play/*.c)),cli/play/none.c)
CLI_SRC := $(sort $(wildcard cli/*.c cli/study/*.c) $(PLAY_SRC))
# Tests and examples that draw are left out where nothing draws.
buildable = $(if $(WITH_RENDER),$(1),$(if $(1),$(shell grep -L 'include .sph2d/render.h' $(1))))
TEST_SRC := $(call buildable,$(sort $(wildcard tests/*.c)))
BENCH_SRC := $(sort $(wildcard tests/bench/*.c))
# Random scenes and their judge, which know the public headers alone.
STRANGERS_SRC := $(sort $(wildcard tests/strangers/*.c))
# The hard cases, which know them, too.
HARD_SRC := $(sort $(wildcard tests/hard/cases/*.c))
# Ways through the pairs, of which those in *_rows.c are compiled for each instruction set.
VARIANTS_SRC := $(sort $(wildcard tests/bench/variants/*.c))
# What frames take.
FRAMES_SRC := $(if $(WITH_RENDER),$(wildcard tests/bench/frames/*.c))
GOLDEN_SRC := tests/golden/golden.c
# What takes any bytes, and what gives them to it.
FUZZ_NAMES := scene study particles table reference drawing snapshot
FUZZ_SRC := $(sort $(wildcard tests/fuzz/*.c))
FUZZ_BIN := $(FUZZ_NAMES:%=$(BUILD)/fuzz/%)
# One opens a window.
EXAMPLES := $(filter-out $(if $(GLFW),,examples/window.c),$(call buildable,$(sort $(wildcard examples/*.c))))
TEMPLATES := cli/study/page.html cli/study/plots.gp
PLAY_SCENES := $(sort $(wildcard cli/play/scenes/*.yaml))
# The programs of devices, each with all that it includes, and headers in place of those of C.
PROGRAMS := $(sort $(filter-out %_shared.cl,$(wildcard src/device/*.cl src/methods/*/*.cl)))
PROGRAM_PARTS := $(wildcard src/*/*.cl src/methods/*/*_shared.cl src/device/clc/*.h src/device/clc/*/*.h src/device/clc/*/*/*.h)
SHADERS := $(sort $(wildcard shaders/*.vert shaders/*.frag))
SCRIPTS := .ci/run .ci/packages.sh cli/completions/sph2d.bash cli/web/sources.sh $(sort $(wildcard tests/cli/run-all tests/cli/*.sh tests/package/*.sh tests/report/*.sh tests/bench/*.sh \
    tests/strangers/*.sh tests/restarts/*.sh tests/threads/*.sh tests/ports/*.sh tests/valgrind/*.sh tests/long/*.sh tests/hard/*.sh \
    tests/golden/*.sh tests/device/*.sh tests/python/*.sh tests/cmake/*.sh tests/adding.sh tests/limit.sh tests/circles.sh tests/words.sh tests/symbols.sh tests/units.sh tests/mutants.sh tests/faults/*.sh tests/fuzz/*.sh tests/coverage/*.sh tests/slurm/*.sh tests/recipes/*.sh examples/*.sh))

# Objects live in a folder named after compiler and flags, so that variants never mix; `variant` changes, and everything
# is linked again, when these or the list of files do.
hash = $(firstword $(shell printf '%s' '$(subst ','\'',$(1))' | cksum))
FLAGS_HASH := $(call hash,$(CC) $(COMPILER) $(MACHINE) $(ALL_CPPFLAGS) $(ALL_CFLAGS) $(CPPFLAGS) $(CFLAGS) \
    $(CORE_FLAGS) $(IO_FLAGS) $(CONTACTS_FLAGS) $(RENDER_FLAGS) $(CLI_FLAGS) $(TEST_FLAGS) \
    $(ISA_FLAGS_avx2) $(ISA_FLAGS_avx512))
OBJ := $(BUILD)/obj/$(FLAGS_HASH)
VARIANT := $(FLAGS_HASH)-$(call hash,$(WITH_SHARED) $(AR) $(ALL_LDFLAGS) $(IO_LIBS) $(CONTACTS_LIBS) $(RENDER_LIBS) $(LDLIBS) \
    $(CORE_SRC) $(IO_SRC) $(STUDY_SRC) $(CONTACTS_SRC) $(RENDER_SRC) $(CLI_SRC) $(TEST_SRC) $(BENCH_SRC) \
    $(STRANGERS_SRC) $(HARD_SRC) $(VARIANTS_SRC) $(FRAMES_SRC) $(SHADERS) $(PROGRAMS))

objects = $(patsubst %.c,$(OBJ)/%.o,$(1))
PASS_OBJ := $(foreach i,$(ISAS),$(PASS_SRC:%.c=$(OBJ)/%.$(i).o))
# The solver has no files: what writes them and reads numbers in them is in the libraries that do.
FILES_BASE_SRC := src/base/atomic_file.c src/base/number.c
CORE_OBJ := $(call objects,$(filter-out $(PASS_SRC) $(FILES_BASE_SRC),$(CORE_SRC))) $(PASS_OBJ) $(OBJ)/gen/kernels.o
# The other libraries carry their own copy of what is private in base; what base exports they take from libsph2d.
BASE_OBJ := $(call objects,$(filter-out $(addprefix src/base/,report.c shared.c version.c),$(filter src/base/%,$(CORE_SRC))))
IO_OBJ := $(call objects,$(IO_SRC))
STUDY_OBJ := $(call objects,$(STUDY_SRC))
CONTACTS_OBJ := $(call objects,$(CONTACTS_SRC))
RENDER_OBJ := $(if $(WITH_RENDER),$(call objects,$(RENDER_SRC)) $(OBJ)/gen/shaders.o)
CLI_OBJ := $(call objects,$(CLI_SRC)) $(OBJ)/gen/study_templates.o $(if $(GLFW),$(OBJ)/gen/play_scenes.o)
TEST_OBJ := $(call objects,$(TEST_SRC))
BENCH_OBJ := $(call objects,$(BENCH_SRC))
STRANGERS_OBJ := $(call objects,$(STRANGERS_SRC))
HARD_OBJ := $(call objects,$(HARD_SRC))
FRAMES_OBJ := $(call objects,$(FRAMES_SRC))
GOLDEN_OBJ := $(call objects,$(GOLDEN_SRC))
FAULTS_OBJ := $(call objects,tests/faults/library.c)
FUZZ_OBJ := $(call objects,$(FUZZ_SRC))
FUZZ_DRIVER_OBJ := $(call objects,$(filter-out $(FUZZ_NAMES:%=tests/fuzz/%.c),$(FUZZ_SRC)))
VARIANTS_OBJ := $(call objects,$(filter-out %_rows.c,$(VARIANTS_SRC))) \
    $(foreach i,$(ISAS),$(patsubst %.c,$(OBJ)/%.$(i).o,$(filter %_rows.c,$(VARIANTS_SRC))))
EXAMPLE_BIN := $(EXAMPLES:%.c=$(BUILD)/%)
EXAMPLE_OBJ := $(call objects,$(EXAMPLES))

LIBRARIES := libsph2d libsph2d-io libsph2d-study libsph2d-contacts $(if $(WITH_RENDER),libsph2d-render)
# From the one that uses to the one that is used, as the linker reads them.
ARCHIVES := $(if $(WITH_RENDER),$(BUILD)/libsph2d-render.a) $(BUILD)/libsph2d-study.a $(BUILD)/libsph2d-contacts.a \
    $(BUILD)/libsph2d-io.a $(BUILD)/libsph2d.a
ARCHIVE_LIBS := $(RENDER_LIBS) $(CONTACTS_LIBS) $(IO_LIBS) $(CORE_LIBS)

# ---- build -----------------------------------------------------------------------------------------------------------
QUIET := $(if $(filter-out 0,$(V)),,quiet)
say = $(if $(QUIET),@printf '  %s %s\n' '$(1)' '$(2)'; )
# Files are counted as they come, of as many as a dry run finds.
ifeq ($(COUNTING),)
TO_COMPILE := $(shell env -u MAKEFLAGS -u MFLAGS $(MAKE) -n COUNTING=1 PACKAGES_CHECKED=1 $(MAKEOVERRIDES) \
    $(MAKECMDGOALS) 2>/dev/null | grep -c '^ *printf .* CC ')
endif
say_compiled = $(eval COMPILED += x)$(if $(QUIET),@printf '  [%s/%s] CC %s\n' $(words $(COMPILED)) '$(TO_COMPILE)' '$(1)'; )
hush := $(if $(QUIET),@)

SCHEMAS := $(addprefix $(BUILD)/,scene.schema.json study.schema.json)
all: lib cli $(SCHEMAS) ## the command, the libraries and the schemas of their files (the default)
lib: $(foreach l,$(LIBRARIES),$(BUILD)/$(l).a $(BUILD)/$(l).so) ## the libraries, static and shared
lib-core: $(BUILD)/libsph2d.a ## the solver alone, static, for other systems: docs/installing.md
cli: $(BUILD)/sph2d ## the command
examples: $(EXAMPLE_BIN) ## the example programs, in BUILD/examples

$(sort $(CORE_OBJ) $(BASE_OBJ)) $(STUDY_OBJ): PART = $(CORE_FLAGS)
$(IO_OBJ): PART = $(IO_FLAGS)
$(CONTACTS_OBJ): PART = $(CONTACTS_FLAGS)
$(RENDER_OBJ): PART = $(RENDER_FLAGS)
$(CLI_OBJ): PART = $(CLI_FLAGS)
$(TEST_OBJ): PART = $(TEST_FLAGS) -Wno-missing-prototypes
$(FRAMES_OBJ) $(STRANGERS_OBJ) $(HARD_OBJ) $(GOLDEN_OBJ) $(FAULTS_OBJ): PART = -Iinclude
$(VARIANTS_OBJ) $(BENCH_OBJ): PART = $(CORE_FLAGS)
$(FUZZ_OBJ): PART = $(CORE_FLAGS) $(call pc_cflags,libxxhash)
$(EXAMPLE_OBJ): PART = -Iinclude $(call pc_cflags,$(GLFW))
$(RENDER_OBJ) $(TEST_OBJ): | $(if $(WITH_RENDER),$(BUILD)/gen/shaders.h)
$(IO_OBJ) $(CONTACTS_OBJ) $(RENDER_OBJ) $(TEST_OBJ): | $(if $(MISSING),packages)

compile = $(call say_compiled,$(1))mkdir -p $(@D) && \
    $(CC) $(ALL_CPPFLAGS) $(ALL_CFLAGS) $(HERE_CFLAGS) $(PART) $(2) $(CPPFLAGS) $(CFLAGS) -c -o $@ $<
link = $(call say,LD,$@)mkdir -p $(@D) && \
    $(CC) $(ALL_CFLAGS) $(CFLAGS) $(ALL_LDFLAGS) $(1) -o $@ $(filter-out $(IN_ARCHIVES),$(filter %.o %.a,$^)) $(2) $(LDLIBS)

define isa_rule
$(OBJ)/src/methods/%_pass.$(1).o: src/methods/%_pass.c
	$$(call compile,$$< ($(1)),$$(ISA_FLAGS_$(1)) -DSPH2D__ISA=$(1))
$(OBJ)/tests/bench/variants/%_rows.$(1).o: tests/bench/variants/%_rows.c
	$$(call compile,$$< ($(1)),$$(ISA_FLAGS_$(1)) -DSPH2D__ISA=$(1))
endef
$(foreach i,$(ISAS),$(eval $(call isa_rule,$(i))))
$(OBJ)/gen/%.o: $(BUILD)/gen/%.c
	$(call compile,$<)
$(OBJ)/%.o: %.c
	$(call compile,$<)

# $(1) name, $(2) objects, $(3) the variable of its libraries, $(4) what must be linked before. No expanded flags as
# arguments: they have commas.
define library_rules
$(BUILD)/$(1).a: $(2) $(BUILD)/variant
	$$(call say,AR,$$@)rm -f $$@ && $$(AR) qcsD $$@ $$(filter %.o,$$^)
$(BUILD)/$(1).so.$(VERSION): $(2) $(4) src/libsph2d.map $(BUILD)/variant
	$$(call link,$$(SHARED_LDFLAGS) -Wl$$(comma)-soname$$(comma)$(1).so.$(SOMAJOR),$$($(3)))
$(BUILD)/$(1).so: $(BUILD)/$(1).so.$(VERSION)
	$(hush)ln -sf $(1).so.$(VERSION) $(BUILD)/$(1).so.$(SOMAJOR) && ln -sf $(1).so.$(SOMAJOR) $$@
endef
IO_SO_LIBS = -L$(BUILD) -lsph2d $(IO_LIBS)
STUDY_SO_LIBS = -L$(BUILD) -lsph2d-io -lsph2d-contacts -lsph2d -lm
CONTACTS_SO_LIBS = -L$(BUILD) -lsph2d $(CONTACTS_LIBS)
RENDER_SO_LIBS = -L$(BUILD) -lsph2d $(RENDER_LIBS)
$(eval $(call library_rules,libsph2d,$(CORE_OBJ),CORE_LIBS))
$(eval $(call library_rules,libsph2d-io,$(IO_OBJ) $(BASE_OBJ),IO_SO_LIBS,$(BUILD)/libsph2d.so))
$(eval $(call library_rules,libsph2d-contacts,$(CONTACTS_OBJ) $(BASE_OBJ),CONTACTS_SO_LIBS,$(BUILD)/libsph2d.so))
$(eval $(call library_rules,libsph2d-study,$(STUDY_OBJ) $(BASE_OBJ),STUDY_SO_LIBS,$(BUILD)/libsph2d-io.so $(BUILD)/libsph2d-contacts.so))
$(eval $(call library_rules,libsph2d-render,$(RENDER_OBJ) $(BASE_OBJ),RENDER_SO_LIBS,$(BUILD)/libsph2d.so))

# What takes longest comes first, so that all processors have work to the end.
ifeq ($(WITH_SHARED),)
$(BUILD)/sph2d: $(PASS_OBJ) $(CLI_OBJ) $(ARCHIVES) $(BUILD)/variant
	$(call link,,$(ARCHIVE_LIBS) $(call pc_libs,$(GLFW)))
$(BUILD)/sph2d: IN_ARCHIVES = $(PASS_OBJ)
else
$(BUILD)/sph2d: $(CLI_OBJ) $(ARCHIVES:.a=.so) $(BUILD)/variant
	$(call link,,-L$(BUILD) $(patsubst $(BUILD)/lib%.a,-l%,$(ARCHIVES)) -lm $(call pc_libs,$(GLFW)))
endif
# By `sph2d help study.schema`, and for scenes `sph2d help schema`.
$(BUILD)/%.schema.json: $(BUILD)/sph2d
	$(call say,GEN,$@)LD_LIBRARY_PATH='$(abspath $(BUILD))' $(BUILD)/sph2d help $(patsubst scene.%,%,$*.schema) >$@.new && mv $@.new $@
$(BUILD)/tests/check_all: $(TEST_OBJ) $(ARCHIVES) $(BUILD)/variant
	$(call link,,$(ARCHIVE_LIBS) $(call pc_libs,check))
$(BUILD)/tests/bench: $(BENCH_OBJ) $(BUILD)/libsph2d.a $(BUILD)/variant
	$(call link,,$(CORE_LIBS))
$(BUILD)/tests/frames: $(FRAMES_OBJ) $(BUILD)/libsph2d-render.a $(BUILD)/libsph2d.a $(BUILD)/variant
	$(call link,,$(RENDER_LIBS) $(CORE_LIBS))
$(BUILD)/tests/strangers: $(STRANGERS_OBJ) $(BUILD)/libsph2d-io.a $(BUILD)/libsph2d-contacts.a $(BUILD)/libsph2d.a \
    $(BUILD)/variant
	$(call link,,$(IO_LIBS) $(CONTACTS_LIBS) $(CORE_LIBS))
$(BUILD)/tests/hard_cases: $(HARD_OBJ) $(BUILD)/libsph2d-io.a $(BUILD)/libsph2d-contacts.a $(BUILD)/libsph2d.a \
    $(BUILD)/variant
	$(call link,,$(IO_LIBS) $(CONTACTS_LIBS) $(CORE_LIBS))
$(BUILD)/tests/golden: $(GOLDEN_OBJ) $(BUILD)/libsph2d-io.a $(BUILD)/libsph2d-contacts.a $(BUILD)/libsph2d.a \
    $(BUILD)/variant
	$(call link,,$(IO_LIBS) $(CONTACTS_LIBS) $(CORE_LIBS))
$(BUILD)/tests/faults_library: $(FAULTS_OBJ) $(BUILD)/libsph2d-io.a $(BUILD)/libsph2d.a $(BUILD)/variant
	$(call link,,$(IO_LIBS) $(CORE_LIBS))
$(BUILD)/tests/faulty_opencl.so: tests/device/faulty.c src/device/opencl_api.h
	$(call say,CC,$@)mkdir -p $(@D) && $(CC) -std=gnu17 -O2 -Wall -Wextra -Isrc -shared -fPIC -pthread -o $@ $<
$(BUILD)/tests/faults_shim.so: tests/faults/shim.c
	$(call say,CC,$@)mkdir -p $(@D) && $(CC) -std=gnu17 -O2 -Wall -Wextra -shared -fPIC -o $@ $<
$(FUZZ_BIN): $(BUILD)/fuzz/%: $(OBJ)/tests/fuzz/%.o $(FUZZ_DRIVER_OBJ) $(BUILD)/libsph2d-study.a \
    $(BUILD)/libsph2d-contacts.a $(BUILD)/libsph2d-io.a $(BUILD)/libsph2d.a $(BUILD)/variant
	$(call link,,$(IO_LIBS) $(CONTACTS_LIBS) $(CORE_LIBS))
$(BUILD)/tests/variants: $(VARIANTS_OBJ) $(OBJ)/tests/bench/bench_machine.o $(BUILD)/libsph2d.a $(BUILD)/variant
	$(call link,,$(CORE_LIBS))
$(EXAMPLE_BIN): $(BUILD)/%: $(OBJ)/%.o $(ARCHIVES) $(BUILD)/variant
	$(call link,,$(ARCHIVE_LIBS) $(if $(findstring window,$@),$(call pc_libs,$(GLFW))))

$(BUILD)/variant: $(if $(filter $(VARIANT),$(file <$(BUILD)/variant)),,FORCE)
	@mkdir -p $(@D) && echo '$(VARIANT)' >$@
FORCE:

# What the times of a study were taken with: told by --version, and a new commit compiles one file. Rows that were run
# are found again as long as the source is the same.
COMMIT = $(or $(if $(wildcard .git),$(shell git -c safe.directory="*" describe --always --dirty --abbrev=12 --exclude '*' 2>/dev/null)),none)
TOLD_CFLAGS = $(subst ",,$(strip $(filter-out -W% -D% -I%,$(ALL_CFLAGS) $(CFLAGS))))
SOURCE_FILES = $(sort $(wildcard src/*/*.[ch] src/methods/*/*.[ch] include/sph2d/*.h cli/*.[ch] cli/study/*.[ch]) $(PROGRAMS) $(PROGRAM_PARTS))
$(BUILD)/gen/build_info.h: FORCE
	@mkdir -p $(@D) && printf '#define BUILD_%s "%s"\n' COMPILER '$(COMPILER)' FLAGS '$(TOLD_CFLAGS)' \
	    COMMIT '$(COMMIT)' SOURCE "$$(cat $(SOURCE_FILES) | cksum | tr ' ' -)" >$@.new && \
	    { cmp -s $@.new $@ && rm $@.new || mv $@.new $@; }
$(OBJ)/cli/build.o: | $(BUILD)/gen/build_info.h

# Shaders and templates become arrays of numbers, since ISO C promises string literals of 4095 characters only. Those of
# shaders are without comments, which would take 2 kB of the page.
bytes_of = od -An -v -td1 $(1) | sed 's/ *\(-*[0-9][0-9]*\)/\1,/g'; echo '0};'
$(BUILD)/gen/shaders.h: Makefile
	$(call say,GEN,$@)mkdir -p $(@D) && printf '%s\n' '#include <stddef.h>' '' \
	    'extern const struct sph2d__shader_source {' '    const char *name, *text;' '} sph2d__shader_sources[];' \
	    'extern const size_t sph2d__shader_source_count;' >$@
$(BUILD)/gen/shaders.c: $(SHADERS) Makefile $(wildcard shaders) | $(BUILD)/gen/shaders.h
	$(call say,GEN,$@){ printf '#include "shaders.h"\n\n'; \
	for f in $(SHADERS); do \
	    echo "static const char $$(basename $$f | tr . _)[] = {"; sed 's, *//.*,,' $$f | $(call bytes_of); \
	done; \
	printf '\nconst struct sph2d__shader_source sph2d__shader_sources[] = {\n'; \
	for f in $(SHADERS); do n=$$(basename $$f); echo "    {\"$$n\", $$(echo $$n | tr . _)},"; done; \
	printf '    {NULL, NULL}};\nconst size_t sph2d__shader_source_count = $(words $(SHADERS));\n'; } >$@
# A program is compiled where it runs; here the compiler puts its files together.
cl_together = $(CC) -x c -E -P -undef -nostdinc -Dkernel=kernel_word -Dhalf=half_word -Ddot=dot_word -Dclamp=clamp_word -Isrc/device/clc -Isrc -Iinclude $(1)
$(BUILD)/gen/kernels.c: $(PROGRAMS) $(PROGRAM_PARTS) $(wildcard include/sph2d/*.h src/*/*.h src/methods/*/*.h) src/particles/ranges.c \
    src/boundary/sweep.c Makefile
	$(call say,GEN,$@)mkdir -p $(@D) && { printf '#include "device/kernels.h"\n\n'; \
	for f in $(PROGRAMS); do \
	    $(call cl_together,$$f) >$(@D)/$$(basename $$f) || exit 1; \
	    echo "static const char $$(basename $$f .cl)[] = {"; $(call bytes_of,$(@D)/$$(basename $$f)); \
	done; \
	printf '\nconst sph2d__program sph2d__programs[] = {\n'; \
	for f in $(PROGRAMS); do n=$$(basename $$f .cl); echo "    {\"$$n\", $$n},"; done; \
	printf '    {0, 0}};\n'; } >$@
$(BUILD)/gen/play_scenes.c: $(PLAY_SCENES) Makefile $(wildcard cli/play/scenes)
	$(call say,GEN,$@)mkdir -p $(@D) && { printf '#include "play/game.h"\n\n'; \
	for f in $(PLAY_SCENES); do \
	    echo "static const char scene_$$(basename $$f .yaml)[] = {"; $(call bytes_of,$$f); \
	done; \
	printf '\nconst play_scene play_scenes[] = {\n'; \
	for f in $(PLAY_SCENES); do n=$$(basename $$f .yaml); echo "    {\"$${n#*_}\", scene_$$n},"; done; \
	printf '};\nconst size_t play_scene_count = $(words $(PLAY_SCENES));\n'; } >$@
$(BUILD)/gen/study_templates.c: $(TEMPLATES) Makefile
	$(call say,GEN,$@)mkdir -p $(@D) && for f in $(TEMPLATES); do \
	    echo "extern const char study_$$(basename $$f | tr . _)[];"; \
	    echo "const char study_$$(basename $$f | tr . _)[] = {"; $(call bytes_of,$$f); \
	done >$@

MISSING_PACKAGES = $(subst +, ,$(foreach m,$(MISSING),$(patsubst $(m)=%,%,$(filter $(m)=%,$(PACKAGES) $(HEADER_PACKAGES)))))
packages:
	@printf '%s\n' 'sph2d: $(MISSING) is missing. "make demo" and "make test" install it; or run:' \
	    '    apt install --no-install-recommends pkgconf $(MISSING_PACKAGES)' >&2; exit 2

include cli/web/web.mk
include tests/ports/ports.mk
-include $(patsubst %.o,%.d,$(sort $(CORE_OBJ) $(BASE_OBJ)) $(IO_OBJ) $(STUDY_OBJ) $(CONTACTS_OBJ) $(RENDER_OBJ) $(CLI_OBJ) $(TEST_OBJ) \
    $(BENCH_OBJ) $(VARIANTS_OBJ) $(FRAMES_OBJ) $(STRANGERS_OBJ) $(HARD_OBJ) $(GOLDEN_OBJ) $(FAULTS_OBJ) $(FUZZ_OBJ) $(EXAMPLE_OBJ))

# ---- demo and tests --------------------------------------------------------------------------------------------------
demo: $(BUILD)/sph2d ## build, simulate a dam break, render it (installs missing packages)
	@$(BUILD)/sph2d check examples/dam_break/scene.yaml | sed -n 's/^time */The dam break of 16,384 particles takes /p'
	$(hush)$(BUILD)/sph2d run examples/dam_break/scene.yaml -o $(BUILD)/demo --force
	@echo "The pictures are in $(BUILD)/demo/frames: $$(ls $(BUILD)/demo/frames | wc -l) files."
	@! command -v ffmpeg >/dev/null || { cd $(BUILD)/demo && ffmpeg -loglevel error -y -framerate 60 -i frames/frame_%06d.png \
	    -pix_fmt yuv420p new.mp4 && mv new.mp4 dam_break.mp4 && echo "The film is $(BUILD)/demo/dam_break.mp4."; } || \
	    echo 'ffmpeg made no film of them.'

# The same bits are those of the usual build; others (a compiler's own wide vectors, another libm) may round otherwise.
GOLDEN := $(if $(or $(SANITIZE),$(CLANG),$(CFLAGS)),,$(X86))
# Calls are made to fail by the names that glibc has for them; sanitizers have their own.
FAULTS := $(if $(SANITIZE),,$(if $(findstring linux-gnu,$(MACHINE)),$(addprefix $(BUILD)/tests/faults_,shim.so library)))
# What pocl, the device of the tests, compiles stays in the build.
test test-full: export POCL_CACHE_DIR = $(abspath $(BUILD)/pocl)
test test-full: export SPH2D_FAULTS = $(abspath $(BUILD)/tests)
test test-full: export LSAN_OPTIONS = suppressions=$(CURDIR)/tests/leaks.supp:print_suppressions=0
# pocl gives threads signal stacks of their own, which ASan takes for its.
test test-full: export ASAN_OPTIONS ?= allocator_may_return_null=1:use_sigaltstack=0
test test-full: override export CK_TIMEOUT_MULTIPLIER := $(shell echo $$(($(CK_TIMEOUT_MULTIPLIER) * $(if $(SANITIZE),5,1))))
test test-full: | $(filter demo test-sanitize,$(MAKECMDGOALS))
test-full: | $(filter test,$(MAKECMDGOALS))
test-variants: | $(filter test test-full test-sanitize test-ports test-foretold,$(MAKECMDGOALS))
# A stage that fails is written down and the next one begins; the last line of a recipe tells all that failed, each by the
# command that runs it again. What is not built, or not in a list, stops at once.
FAILED = $(BUILD)/tests/failed-$@
first_stage = @mkdir -p $(dir $(FAILED)) && rm -f $(FAILED)
stage = $(hush)($(1)) || printf '    %s\n' '$(subst ','\'',$(1))' >>$(FAILED)
last_stage = @test ! -e $(FAILED) || { echo 'make $@: failed:' && cat $(FAILED) && exit 1; } >&2
# Python is not built with sanitizers: gcc's come before all other libraries, clang's are none.
LATE = tests/device/late.sh $(BUILD)/tests/faulty_opencl.so $(BUILD)/device_late
PYTHON_SANITIZED = $(if $(SANITIZE),LD_PRELOAD="$$($(CC) -print-file-name=libasan.so) \
    $$($(CC) -print-file-name=libubsan.so)" ASAN_OPTIONS=detect_leaks=0)
WITH_NUMPY = $(firstword $(shell for p in $(PYTHONS); do "$$p" -c 'import numpy' 2>/dev/null && echo "$$p"; done))
# Not by the name that make runs lines for in a dry run, too.
THIS_MAKE := $(MAKE)
# Two tiers: what every change must pass, within minutes, and what takes longer.
TESTED := $(BUILD)/sph2d $(BUILD)/tests/check_all $(if $(GOLDEN),$(BUILD)/tests/golden $(BUILD)/tests/faulty_opencl.so) $(FUZZ_BIN) $(FAULTS) \
    $(foreach l,$(LIBRARIES),$(BUILD)/$(l).so)
test: $(TESTED) $(EXAMPLE_BIN) ## what every change must pass (installs missing packages)
	@for s in $$(sed -n 's/^Suite \*suite_\([a-z0-9_]*\)(.*/\1/p' $(TEST_SRC)); do \
	    grep -q "X($$s)" tests/suites.h || { echo "tests/suites.h lacks $$s"; exit 1; }; done
	@for f in $$(sed -n '/^SPH2D_API/,/;/p' include/sph2d/*.h | tr '\n' ' ' | tr ';' '\n' | \
	    sed -n 's/.*\<\(sph2d_[a-z0-9_]*\)([^)]*\*.*/\1/p'); do \
	    grep -q "$$f(" tests/test_null*.c || { echo "tests/test_null.c lacks $$f"; exit 1; }; done
	$(first_stage)
	$(if $(SANITIZE),,$(call stage,tests/symbols.sh $(BUILD)/libsph2d.so $(OPENMP)))
	$(call stage,tests/words.sh $(filter src/% cli/%,$(C_FILES)))
	$(call stage,tests/circles.sh $(sort $(CORE_OBJ) $(BASE_OBJ)) $(IO_OBJ) $(STUDY_OBJ) $(CONTACTS_OBJ) $(RENDER_OBJ) $(CLI_OBJ))
	$(call stage,SPH2D=$(BUILD)/sph2d tests/cli/run-all -j "$$(nproc)" --short)
	$(if $(and $(SANITIZE),$(CLANG)),,$(call stage,SPH2D=$(abspath $(BUILD)/sph2d) CC='$(CC)' $(PYTHON_SANITIZED) \
	    tests/python/run.sh '$(WITH_NUMPY)' $(BUILD)))
	$(if $(and $(WITH_RENDER),$(if $(SANITIZE),,1)),$(call stage,tests/recipes/tutorial.sh $(BUILD)/sph2d '$(WITH_NUMPY)' \
	    $(BUILD)/tutorial '$(THIS_MAKE)'))
	$(if $(SANITIZE),,$(call stage,tests/python/wheel.sh '$(PYTHONS)' $(BUILD)/wheel))
	$(if $(SANITIZE),,$(call stage,tests/cmake/cmake.sh $(BUILD)/cmake '$(THIS_MAKE)' '$(BUILD)' '$(CC)'))
	$(call stage,tests/fuzz/fuzz.sh $(BUILD)/sph2d $(BUILD)/fuzz $(BUILD)/fuzz/found)
	$(if $(GOLDEN),$(call stage,tests/golden/golden.sh $(BUILD)/tests/golden $(BUILD)/golden "$$(nproc)" --own))
	$(if $(GOLDEN),$(call stage,tests/device/bits.sh $(BUILD) jobs="$$(nproc)" steps=10))
	$(if $(GOLDEN),$(call stage,$(LATE) tests/device/bits.sh $(BUILD) jobs="$$(nproc)" methods=own steps=1000 scenes='dam_break/scene drop/scene report/realtime'))
	$(if $(GOLDEN),$(call stage,$(LATE) env CK_RUN_SUITE=device $(BUILD)/tests/check_all))
	$(if $(GOLDEN),$(call stage,tests/device/faults.sh $(BUILD)/tests/golden $(BUILD)/tests/faulty_opencl.so $(BUILD)/device_faults 12 6))
	$(call stage,CK_EXCLUDE_TAGS=long tests/units.sh $(BUILD)/tests/check_all $(BUILD)/units "$$(nproc)")
	$(last_stage)

# Random scenes have seeds of their own each time: the second it is.
FRESH := $(shell date +%s)
# A tenth of the mutants, 0 to 9, another one each day. They are the same in all variants of the build.
TENTH ?= $(shell echo $$(($(FRESH) / 86400 % 10)))
# Per cent of them that may live without a word in tests/mutants/survivors: many have never been looked at. Only less.
MOST_LIVE := 45
test-full: $(BUILD)/tests/bench $(BUILD)/tests/variants $(BUILD)/tests/strangers $(BUILD)/tests/hard_cases $(if $(WITH_RENDER),$(BUILD)/tests/frames)
test-full: $(BUILD)/tests/core_scenes $(BUILD)/tests/embed
test-full: $(TESTED) ## the rest: long runs of physics, random scenes, kills, resumed runs, a tenth of the mutants (an hour)
	$(first_stage)
	$(call stage,SPH2D=$(BUILD)/sph2d tests/cli/run-all -j "$$(nproc)" --long)
	$(call stage,tests/recipes/recipes.sh $(BUILD)/sph2d '$(PYTHONS)' $(BUILD)/recipes)
	$(if $(SANITIZE),,$(call stage,CC='$(CC)' OPENMP='$(OPENMP)' RENDER='$(RENDER)' tests/python/wheel.sh --pypi '$(PYTHONS)' $(BUILD)/wheel-pypi))
	$(call stage,$(BUILD)/tests/bench --particles 1000 --steps 5 --runs 1 --csv >$(BUILD)/tests/bench.csv)
	$(if $(GOLDEN),$(call stage,tests/device/bits.sh $(BUILD) jobs="$$(nproc)" methods=own steps=1000))
	$(if $(GOLDEN),$(call stage,tests/device/one_source.sh $(BUILD)))
	$(if $(GOLDEN),$(call stage,tests/device/faults.sh $(BUILD)/tests/golden $(BUILD)/tests/faulty_opencl.so $(BUILD)/device_faults))
	$(call stage,$(BUILD)/tests/variants --particles 1000 --rounds 1 >$(BUILD)/tests/variants.txt)
	$(if $(WITH_RENDER),$(call stage,$(BUILD)/tests/frames 300 1 1 >$(BUILD)/tests/frames.txt))
	$(call stage,tests/bench/command.sh $(BUILD)/sph2d particles=300 seconds=0.02 pairs=1 >$(BUILD)/tests/command.txt)
	$(call stage,tests/strangers/liars.sh $(BUILD)/sph2d $(BUILD)/tests/strangers $(BUILD)/tests/liars)
	$(call stage,$(STRANGERS_KNOWN) --seeds 1..$(if $(SPH2D_TEST_FULL),200,20))
	$(call stage,$(STRANGERS_KNOWN) --seeds 1001..$(if $(SPH2D_TEST_FULL),1100,1010))
	$(call stage,$(STRANGERS_KNOWN) --seeds 2001..$(if $(SPH2D_TEST_FULL),2100,2010))
	$(call stage,$(STRANGERS_KNOWN) --seeds 3001..$(if $(SPH2D_TEST_FULL),3060,3010))
	$(call stage,$(STRANGERS_KNOWN) --seeds 4001..$(if $(SPH2D_TEST_FULL),4100,4020))
	$(hush)$(STRANGERS) --jobs "$$(nproc)" --seeds $(FRESH)..$$(($(FRESH) + 9)) || echo 'New scenes that fail are finds, of the code as it was before, too.'
	$(call stage,$(RESTARTS) "$$(nproc)" 1..$(if $(SPH2D_TEST_FULL),200,12))
	$(call stage,$(RESTARTS) "$$(nproc)" 1001..$(if $(SPH2D_TEST_FULL),1100,1006))
	$(call stage,$(RESTARTS) "$$(nproc)" 4001..$(if $(SPH2D_TEST_FULL),4100,4006))
	$(call stage,$(RESTARTS) "$$(nproc)" 2005..$(if $(SPH2D_TEST_FULL),2100,2015))
	$(call stage,$(RESTARTS) "$$(nproc)" 3001..$(if $(SPH2D_TEST_FULL),3060,3006))
	$(call stage,$(RESTARTS) "$$(nproc)" $(FRESH)..$$(($(FRESH) + 5)))
	$(call stage,$(RESTARTS) "$$(nproc)" tests/restarts/scenes)
	$(if $(GOLDEN),$(call stage,DEVICE="$$(tests/device/pocl.sh $(BUILD)/sph2d)" $(RESTARTS) "$$(nproc)" 1..$(if $(SPH2D_TEST_FULL),400,40)))
	$(call stage,$(KILLS) $(if $(SPH2D_TEST_FULL),500,10))
	$(call stage,$(HARD_CASES) --short $(if $(GOLDEN),,A) >$(BUILD)/tests/hard_cases.md || \
	    { grep -E 'MISSED|WORSE|HOLDS' $(BUILD)/tests/hard_cases.md; exit 1; })
	$(if $(GOLDEN),$(call stage,tests/golden/golden.sh $(BUILD)/tests/golden $(BUILD)/golden "$$(nproc)"))
	$(if $(GOLDEN),$(call stage,$(PORTS_TEST) windows macos))
	$(call stage,CK_INCLUDE_TAGS=long tests/units.sh $(BUILD)/tests/check_all $(BUILD)/units-long "$$(nproc)")
	$(if $(and $(GOLDEN),$(WITH_OPENMP),$(WITH_RENDER)),$(call stage,SHARE=$(TENTH)/10 SECONDS_EACH=5 LIVE=$(MOST_LIVE) tests/mutants.sh))
	$(last_stage)

both_tiers = $(call stage,$(MAKE) $(1) test)$(newline)	$(call stage,$(MAKE) $(1) test-full)
define newline


endef
test-sanitize: ## both under AddressSanitizer and UBSan, in BUILD/sanitize
	$(first_stage)
	$(call both_tiers,BUILD=$(BUILD)/sanitize SANITIZE=address,undefined)
	$(last_stage)

FUZZ_SECONDS ?= 1800
test-fuzz: ## hostile files under the sanitizers, FUZZ_SECONDS=1800 for each of seven readers
	$(hush)$(MAKE) BUILD=$(BUILD)/sanitize SANITIZE=address,undefined fuzz-run

fuzz-run: $(BUILD)/sph2d $(FUZZ_BIN)
	$(hush)tests/fuzz/fuzz.sh $(BUILD)/sph2d $(BUILD)/fuzz $(BUILD)/fuzz/found --seconds $(FUZZ_SECONDS) \
	    --seed "$$(date +%s)" --limit 10

# Calls are not inlined and conditions not merged, so that lines and branches are those of the source.
COVERAGE_CFLAGS := -O1 -fno-inline --param logical-op-non-short-circuit=0 --coverage -fprofile-update=atomic -Wno-psabi
COVERAGE_EXIT := $(abspath $(BUILD))/coverage/exit.o
coverage: ## lines and branches that the tests run, as a table; fails below 90 % and 80 % (10 minutes; gcc)
	$(hush)mkdir -p $(BUILD)/coverage && $(CC) -std=c17 -O1 -c -o $(COVERAGE_EXIT) tests/coverage/exit.c
	$(hush)$(MAKE) BUILD=$(BUILD)/coverage CFLAGS='$(COVERAGE_CFLAGS)' CPPFLAGS=-Dalways_inline=unused \
	    LDFLAGS='-Wl,--wrap=_exit $(COVERAGE_EXIT)' coverage-run

coverage-run: $(BUILD)/sph2d $(BUILD)/tests/check_all $(BUILD)/tests/strangers $(BUILD)/tests/hard_cases $(FUZZ_BIN) $(FAULTS)
	$(hush)tests/coverage/coverage.sh $(BUILD) $(OBJ) "$$(nproc)"

THREADS_CC ?= clang
test-threads: ## data races, by clang's ThreadSanitizer with libomp's archer (10 minutes); THREADS_CC=clang
	$(hush)tests/threads/threads.sh --needs $(THREADS_CC)
	$(hush)$(MAKE) BUILD=$(BUILD)/threads CC=$(THREADS_CC) SANITIZE=thread threads-run

threads-run: $(BUILD)/sph2d $(BUILD)/tests/check_all
	$(hush)CC='$(CC)' tests/threads/threads.sh $(BUILD)/sph2d $(BUILD)/tests/check_all $(BUILD)/races

test-valgrind: $(BUILD)/sph2d $(BUILD)/tests/check_all ## memory read before it is written, and lost, by valgrind's memcheck (10 minutes)
	$(hush)tests/valgrind/valgrind.sh $(BUILD)/sph2d $(BUILD)/tests/check_all $(BUILD)/valgrind "$$(nproc)"

PORTS_TEST = tests/ports/ports.sh $(BUILD)/tests/core_scenes $(BUILD)/ports '$(THIS_MAKE)'
test-ports: $(BUILD)/tests/core_scenes $(BUILD)/tests/embed ## the core for aarch64, 32-bit x86, musl, without optimisation, Windows, macOS (25 minutes); PORTS='aarch64 i686 musl O0 windows macos macos-x86_64'
	$(hush)$(PORTS_TEST) $(PORTS)

test-mutants: ## does a wrong formula fail a test? changes each constant and sign once (15 hours; SECONDS_EACH=5: 4)
	$(hush)tests/mutants.sh

OTHER_CC := $(if $(CLANG),gcc,clang)
# Where the compiler's own flags widen vectors, even the baseline's loops have four lanes.
test-variants: all check-headers check-symbols check-install ## both tiers in every variant of the build, with more seeds (hours)
	$(first_stage)
	$(call both_tiers,BUILD=$(BUILD)/no-openmp OPENMP=0)
	$(call both_tiers,BUILD=$(BUILD)/no-render RENDER=0)
	$(if $(X86),$(call both_tiers,BUILD=$(BUILD)/wide CFLAGS='$(CFLAGS) -mavx2 -mfma'))
	$(hush)echo '#include <omp.h>' | $(OTHER_CC) -fopenmp -E - >/dev/null 2>&1 || echo '$(OTHER_CC) with OpenMP: not installed'
	$(if $(shell echo '\#include <omp.h>' | $(OTHER_CC) -fopenmp -E - 2>/dev/null),$(call both_tiers,BUILD=$(BUILD)/$(OTHER_CC) CC=$(OTHER_CC)))
	$(call stage,$(MAKE) test-sanitize)
	$(call stage,$(MAKE) test-ports)
	$(call stage,$(MAKE) test-foretold)
	$(call stage,tests/adding.sh $(BUILD)/adding)
	$(call both_tiers,SPH2D_TEST_FULL=1)
	$(last_stage)

golden: $(BUILD)/tests/golden ## renews tests/golden/hashes, in a commit that says why the numbers moved
	$(hush)tests/golden/golden.sh $(BUILD)/tests/golden $(BUILD)/golden "$$(nproc)" --renew

test-same-bits: $(BUILD)/tests/golden ## that 1, 2, 3, 5 and 8 threads give the same bits (20 minutes)
	$(hush)tests/golden/threads.sh $(BUILD)/tests/golden $(BUILD)/same-bits "$$(nproc)"

DEVICE ?= $(error make test-device DEVICE=N: a number of `sph2d devices`)
test-device: $(BUILD)/sph2d $(BUILD)/tests/golden ## that a device makes the processor's bits: every example for 1,000 steps; DEVICE=1
	$(hush)tests/device/bits.sh $(BUILD) device=$(DEVICE) steps=1000 particles=1e9

test-package: ## the source archive, and its Debian packages built, checked and used in fresh systems (15 minutes, as root)
	$(hush)tests/package/package.sh --needs
	$(hush)$(MAKE) dist
	$(hush)tests/package/package.sh $(DIST) $(BUILD)/package

STRANGERS = $(BUILD)/tests/strangers --command $(BUILD)/sph2d --dir $(BUILD)/strangers
STRANGERS_KNOWN = $(STRANGERS) --jobs "$$(nproc)" --known tests/strangers/known_failures
strangers: $(BUILD)/sph2d $(BUILD)/tests/strangers ## random scenes judged by invariants; SEEDS=1..2000
	$(hush)$(STRANGERS) --jobs "$$(nproc)" --seeds $(or $(SEEDS),1..200)

test-foretold: $(BUILD)/sph2d $(BUILD)/tests/strangers ## what check foretells of every example against its run (10 minutes)
	$(hush)tests/strangers/foretold.sh $(BUILD)/sph2d $(BUILD)/tests/strangers $(BUILD)/foretold

RESTARTS = tests/restarts/restarts.sh $(BUILD)/sph2d $(BUILD)/tests/strangers $(BUILD)/restarts
test-restarts: $(BUILD)/sph2d $(BUILD)/tests/strangers ## random scenes stopped and resumed, byte for byte; SEEDS=1..200
	$(hush)$(RESTARTS) "$$(nproc)" $(or $(SEEDS),1..200)
	$(hush)$(RESTARTS) "$$(nproc)" tests/restarts/scenes

KILLS = tests/restarts/kills.sh $(BUILD)/sph2d $(BUILD)/kills
test-kills: $(BUILD)/sph2d ## runs, one with openings, killed at random moments: no torn file, the same folder in the end; KILLED=500
	$(hush)$(KILLS) $(or $(KILLED),500)
	$(hush)SCENE='$(CURDIR)/tests/restarts/channel.yaml' $(KILLS) $(or $(KILLED),500)

RECIPES_PYTHON := $(BUILD)/recipes-python
test-recipes: $(BUILD)/sph2d ## the recipes of docs/recipes.md, none left out (2 minutes; pip gets 250 MB of packages, 1.3 GB unpacked)
	$(hush)tests/recipes/packages.sh '$(firstword $(PYTHONS))' $(RECIPES_PYTHON)
	$(hush)tests/recipes/recipes.sh --all $(BUILD)/sph2d $(abspath $(RECIPES_PYTHON))/bin/python $(BUILD)/recipes

test-long: $(BUILD)/sph2d ## tanks and streams for a million steps, by every method (20 minutes); STEPS=1000000
	$(hush)tests/long/long.sh $(BUILD)/sph2d $(BUILD)/long "$$(nproc)" $(or $(STEPS),1000000)

test-slurm: $(BUILD)/sph2d ## a study of 32 rows as an array job of a real Slurm (a minute; installs Debian's)
	$(hush)tests/slurm/slurm.sh $(BUILD)/sph2d $(BUILD)/slurm

strangers-dozen: $(BUILD)/sph2d $(BUILD)/tests/strangers ## a dozen six-line scenes by every method: energy, level, time
	$(hush)tests/strangers/dozen.sh $(BUILD)/sph2d $(BUILD)/tests/strangers $(BUILD)/dozen "$$(nproc)"

test-faults: $(BUILD)/sph2d $(FAULTS) ## every allocation, write, sync, rename fails once (10 minutes; FULL=1: hours)
	$(hush)tests/faults/faults.sh $(BUILD)/sph2d $(FAULTS) $(BUILD)/faults "$$(nproc)"

# Both tables, whatever the first says.
HARD_CASES = $(BUILD)/tests/hard_cases --jobs "$$(nproc)" --known tests/hard/known_failures
test-hard: $(BUILD)/sph2d $(BUILD)/tests/hard_cases ## scenes that nobody tuned, and hard cases, by every method, against their bounds (10 minutes)
	$(hush)mkdir -p $(BUILD)/hard; $(HARD_CASES) >$(BUILD)/hard/cases.md; hard=$$?; cat $(BUILD)/hard/cases.md; \
	    tests/hard/hard.sh $(BUILD)/sph2d $(BUILD)/hard "$$(nproc)" && exit $$hard

hard-docs: ## puts the table of hard cases of the last test-hard into docs/validation.md
	$(hush)sed -i -e '/^<!-- hard -->/,/^<!-- end of hard -->/{//!d}' \
	    -e '/^<!-- hard -->/r $(BUILD)/hard/cases.md' docs/validation.md

OF_DEVICES := wcsph,muller,constraint
bench: $(BUILD)/tests/bench ## how fast steps are, by method, size, threads; BENCH='--particles 16000,1000000'; DEVICE=1: on a device
	$(hush)$(BUILD)/tests/bench $(if $(filter command environment,$(origin DEVICE)),--device $(DEVICE) --scenes $(OF_DEVICES)) $(BENCH)

bench-command: $(BUILD)/sph2d ## the command's own choice of threads against one thread; COMMAND='beside particles=1000,1000000'
	$(hush)tests/bench/command.sh $(BUILD)/sph2d $(COMMAND)

bench-instructions: $(BUILD)/tests/bench ## instructions that a particle takes in a step, by callgrind; SCENES='wcsph fitted'
	$(hush)tests/bench/instructions.sh $(BUILD)/tests/bench $(SCENES)

bench-variants: $(BUILD)/tests/variants ## ways through the pairs beside the library's; VARIANTS='--particles 250000 --isa avx512'
	$(hush)$(BUILD)/tests/variants $(VARIANTS)

bench-frames: $(BUILD)/tests/frames ## CPU time of frames, drawn by one thread; FRAMES='4000 2 3' (particles, frames, rounds)
	$(hush)$(BUILD)/tests/frames $(FRAMES)

# ---- what an error costs ---------------------------------------------------------------------------------------------
REPORT := tests/report/report.sh $(BUILD)/sph2d
report: $(BUILD)/sph2d ## what an error costs: all studies as one page, BUILD/report/index.html (25 minutes)
	$(hush)$(REPORT) $(BUILD)/report --jobs "$$(nproc)" --repeat 3

report-full: $(BUILD)/sph2d ## the same with the rows that take long, in BUILD/report-full (hours)
	$(hush)$(REPORT) $(BUILD)/report-full --jobs "$$(nproc)" --repeat 3 --all

report-docs: ## puts the table of the last report into docs/validation.md
	$(hush)sed -i -e '/^<!-- cases -->/,/^<!-- end of cases -->/{//!d}' \
	    -e '/^<!-- cases -->/r $(BUILD)/report/cases.md' docs/validation.md

gallery: $(BUILD)/sph2d ## run the scenes of docs/gallery.md and write it with their pictures (10 min of CPU time)
	$(hush)python3 examples/gallery.py $(BUILD)/sph2d

scene-docs: $(BUILD)/sph2d ## puts the keys of scenes into docs/scenes.md and cli/sph2d-scene.5
	$(hush)$(BUILD)/sph2d help scene.md >$(BUILD)/scene.md
	$(hush)sed -i -e '/^<!-- keys -->/,/^<!-- end of keys -->/{//!d}' \
	    -e '/^<!-- keys -->/r $(BUILD)/scene.md' docs/scenes.md
	$(hush)$(BUILD)/sph2d help scene.5 >$(BUILD)/scene.5
	$(hush)sed -i -e '/^\.\\" keys/,/^\.\\" end of keys/{//!d}' \
	    -e '/^\.\\" keys/r $(BUILD)/scene.5' cli/sph2d-scene.5

python-docs: $(BUILD)/libsph2d-io.so ## puts the names of the Python module into docs/python.md
	$(hush)SPH2D_LIBRARY_DIR='$(BUILD)' '$(WITH_NUMPY)' tests/python/api.py >$(BUILD)/api.md
	$(hush)sed -i -e '/^<!-- api -->/,/^<!-- end of api -->/{//!d}' \
	    -e '/^<!-- api -->/r $(BUILD)/api.md' docs/python.md

# ---- checks ----------------------------------------------------------------------------------------------------------
HEADERS := $(filter-out $(if $(WITH_RENDER),,%/render.h),$(sort $(wildcard include/sph2d/*.h)))
HEADER_LANGUAGES := 'c -std=c11' 'c -std=c17' $(if $(shell command -v $(firstword $(CXX))),'c++ -std=c++17')
check-headers: ## each public header compiles alone, as C11, C17 and C++17
	$(hush)for h in $(HEADERS:include/%=%); do for lang in $(HEADER_LANGUAGES); do \
	    case $$lang in c++*) cc='$(CXX)';; *) cc='$(CC)';; esac; \
	    printf '#include <%s>\ntypedef int not_empty;\n' "$$h" | \
	        $$cc -x $$lang -Wall -Wextra -Wpedantic -Werror -Iinclude -fsyntax-only - || exit 1; \
	done; done; echo 'headers: ok'

check-symbols: lib ## what the shared libraries export and need
	$(hush)nm -D --defined-only $(LIBRARIES:%=$(BUILD)/%.so) | sed -n 's/@.*//; s/^[0-9a-f]* [A-Z] //p' | \
	    grep -v '^SPH2D_' | sort >$(BUILD)/exported; \
	sed -n 's/^SPH2D_API .*\<\(sph2d_[a-z0-9_]*\)(.*/\1/p' $(HEADERS) | sort >$(BUILD)/declared; \
	diff $(BUILD)/declared $(BUILD)/exported || { echo 'symbols: declared (<) and exported (>) differ'; exit 1; }
	$(hush)tests/symbols.sh $(BUILD)/libsph2d.so $(OPENMP)

# Below a folder with a space, by somebody whose files are private.
STAGING := $(abspath $(BUILD))/staging
STAGED := share/bash-completion/completions/sph2d share/zsh/site-functions/_sph2d \
    share/sph2d/scene.schema.json share/sph2d/study.schema.json \
    $(addprefix share/doc/sph2d/,LICENSE README.md docs/scenes.md examples/README.md examples/dam_break/scene.yaml)
STAGE := prefix='$(STAGING)/my tools' libdir='$(STAGING)/my tools/lib' pkgconfigdir='$(STAGING)/my tools/lib/pkgconfig'
check-install: all ## install into a scratch folder, build the examples there with pkg-config alone, run them
	$(hush)rm -rf '$(STAGING)'; mkdir -p '$(STAGING)/run'
	$(hush)umask 077; $(MAKE) install $(STAGE) >/dev/null
	$(hush)to='$(STAGING)/my tools'; cd '$(STAGING)/run'; \
	hidden=$$(find "$$to" -type f ! -perm -o=r -o -type d ! -perm -o=rx); \
	test -z "$$hidden" || { echo "install: others cannot read $$hidden"; exit 1; }; \
	module=$$(find "$$to" -path '*/sph2d/__init__.py'); test -n "$$module" || { echo 'install: the Python module is missing'; exit 1; }; \
	test -z '$(WITH_NUMPY)' || PYTHONPATH=$${module%/sph2d/*} '$(WITH_NUMPY)' '$(CURDIR)'/examples/embed.py >log || exit 1; \
	export PKG_CONFIG_PATH="$$to/lib/pkgconfig" LD_LIBRARY_PATH="$$to/lib"; \
	for static in '' --static; do \
	    test -z "$$static" || rm "$$to"/lib/*.so*; \
	    for e in $(filter-out examples/window.c,$(EXAMPLES)); do \
	        uses=$$(sed -n 's/^#include <sph2d\/\(io\|contacts\|render\)\.h>.*/sph2d-\1/p' '$(CURDIR)'/$$e); \
	        flags=$$($(PKG_CONFIG) $$static --cflags --libs $${uses:-sph2d}) && \
	        eval "$(CC) '$(CURDIR)'/$$e -o example $$flags $(SANITIZERS)" && \
	        '$(CURDIR)'/tests/limit.sh 300 ./example >log || { echo "install: $$e fails $$static"; exit 1; }; \
	    done; \
	done; \
	$(PKG_CONFIG) --exists --print-errors $(LIBRARIES:lib%=%) || exit 1; \
	for p in $(notdir $(MAN_PAGES)); do \
	    test -s "$$to/share/man/man$${p##*.}/$$p" || { echo "install: $$p is missing"; exit 1; }; \
	done; \
	for f in $(STAGED); do \
	    test -s "$$to/$$f" || { echo "install: $$f is missing"; exit 1; }; \
	done; \
	"$$to/bin/sph2d" check "$$to/share/doc/sph2d/examples/sprinkler/scene.yaml" >/dev/null || exit 1
	$(hush)$(MAKE) uninstall $(STAGE) >/dev/null
	$(hush)left=$$(find '$(STAGING)/my tools' ! -type d); \
	test -z "$$left" || { echo "install: uninstall leaves $$left"; exit 1; }; echo 'install: ok'

C_FILES := $(sort $(CORE_SRC) $(BENCH_SRC) $(VARIANTS_SRC) $(FRAMES_SRC) $(STRANGERS_SRC) $(HARD_SRC) $(GOLDEN_SRC) $(FUZZ_SRC) \
    $(IO_SRC) $(STUDY_SRC) $(CONTACTS_SRC) tests/faults/library.c tests/device/faulty.c tests/ports/core_scenes.c tests/cmake/parts.c $(CLI_SRC) $(wildcard src/render/*.c tests/*.c examples/*.c))
ALL_C := $(sort $(C_FILES) $(wildcard include/sph2d/*.h src/*/*.h src/methods/*/*.h cli/*.h cli/study/*.h tests/*.h tests/bench/*.h \
    tests/bench/variants/*.h tests/strangers/*.h tests/faults/*.c tests/cmake/*.c tests/ports/*.[ch] tests/fuzz/*.h tests/hard/cases/*.h))
LINT_FLAGS = -std=c17 -D_POSIX_C_SOURCE=200809L -DSPH2D__ISA=baseline $(CORE_FLAGS) $(RENDER_FLAGS) $(IO_FLAGS) \
    $(TEST_FLAGS) $(OMP_CFLAGS)
# cppcheck leaves the tests to clang-tidy: it does not see that a failed ck_assert does not return.
if_installed = if ! command -v $(1) >/dev/null; then echo '$(1): not installed'; else echo '$(1)';
TIDY ?= $(C_FILES)
check-lint: check-walls $(BUILD)/gen/build_info.h $(if $(WITH_RENDER),$(BUILD)/gen/shaders.h) ## clang-format, shellcheck, cppcheck, clang-tidy (15 minutes; TIDY=FILES)
	$(hush)$(call if_installed,clang-format) bad=; \
	    for f in $(ALL_C); do clang-format $$f | cmp -s $$f || bad="$$bad $$f"; done; \
	    test -z "$$bad" || { echo "make format changes$$bad"; exit 1; }; fi
	$(hush)$(call if_installed,shellcheck) shellcheck $(SCRIPTS); fi
	$(hush)$(call if_installed,cppcheck) cppcheck --quiet --std=c11 --enable=warning,performance,portability \
	    --inline-suppr --error-exitcode=1 -j "$$(nproc)" -Iinclude -Isrc \
	    -DSPH2D__ISA=baseline $(filter-out tests/%,$(C_FILES)); fi
	$(hush)$(call if_installed,clang-tidy) printf '%s\n' $(filter $(C_FILES),$(TIDY)) | \
	    xargs -r -P "$$(nproc)" -I{} clang-tidy --quiet {} -- $(LINT_FLAGS) 2>$(BUILD)/clang-tidy.log; fi

# Beside the order above: files, study, contacts and render use base alone, the command only the public headers.
METHOD_DIRS := $(filter-out %/common %/terms,$(filter methods/%,$(CORE_DIRS)))
check-walls: ## no folder includes what it must not know
	$(hush)set -- $(CORE_DIRS); below=$$*; \
	for d in files study contacts render $$*; do \
	    case $$d in files|study|contacts|render) bad="$${below#base } files study contacts render";; \
	        *) shift; bad="$$* files study contacts render";; esac; \
	    case $$d in methods/common|methods/terms) ;; methods/*) bad="$$bad $(METHOD_DIRS)";; esac; \
	    for b in $$bad; do \
	        test $$b = $$d || ! grep -nsE "#include [<\"]$$b/[a-z_]+\.(h|cl)" src/$$d/*.[ch] src/$$d/*.cl || exit 1; \
	    done; \
	done; ! grep -rn '#include ".*\.\./\(src\|include\)/' cli || exit 1; \
	! grep -n '#include "study/' cli/*.[ch] || exit 1; echo 'walls: ok'

format: ## rewrite the C files with clang-format
	clang-format -i $(ALL_C)

# ---- installation ----------------------------------------------------------------------------------------------------
# As pkg-config's files write a path, which may have spaces, and as sed takes it.
empty :=
pc_path = $(subst $(empty) ,\\ ,$(subst |,\|,$(subst &,\&,$(subst \,\\\\,$(subst $(prefix)/,$${prefix}/,$(1))))))
pc_fill = sed 's|@prefix@|$(call pc_path,$(prefix))|; s|@libdir@|$(call pc_path,$(libdir))|; \
    s|@includedir@|$(call pc_path,$(includedir))|; s|@version@|$(VERSION)|g; s|@gl@|$(GL)|; s|@openmp@|$(if $(WITH_OPENMP),-fopenmp)|'
# Those of CMake find the libraries from where they are themselves.
to_folder = $(shell realpath -m -s --relative-to='$(cmakedir)' '$(1)')
cmake_fill = sed 's|@to_lib@|$(call to_folder,$(libdir))|; s|@to_include@|$(call to_folder,$(includedir))|; s|@version@|$(VERSION)|; \
    s|@gl@|$(GL)|; s|@openmp@|$(if $(WITH_OPENMP),-fopenmp)|'
MAN_PAGES := $(sort $(wildcard cli/*.1 cli/*.3 cli/*.5))
man_dir = $D$(mandir)/man$(patsubst .%,%,$(suffix $(1)))
# In the folders that they have here, so that their links hold.
DOC_FILES := LICENSE README.md CHANGELOG.md $(sort $(wildcard docs/*.md docs/*.gif docs/*.png docs/gallery/*.png docs/notes/*.md examples/*.* \
    $(foreach e,yaml csv svg py md txt,examples/*/*.$(e))))
MODULE_FILES := $(sort $(wildcard python/sph2d/*.py python/sph2d/py.typed))
D = $(DESTDIR)
install: all ## to prefix (/usr/local), below DESTDIR
	$(INSTALL) -d '$D$(bindir)' '$D$(libdir)' '$D$(pkgconfigdir)' '$D$(cmakedir)' '$D$(includedir)/sph2d' '$D$(pythondir)/sph2d' \
	    $(foreach p,$(MAN_PAGES),'$(call man_dir,$(p))') '$D$(bashcompletiondir)' '$D$(zshcompletiondir)' \
	    '$D$(datadir)/sph2d' $(foreach d,$(sort $(dir $(DOC_FILES))),'$D$(docdir)/$(d)')
	$(INSTALL) -m 755 $(BUILD)/sph2d '$D$(bindir)/sph2d'
	$(INSTALL) -m 644 $(LIBRARIES:%=$(BUILD)/%.a) '$D$(libdir)'
	$(INSTALL) -m 755 $(LIBRARIES:%=$(BUILD)/%.so.$(VERSION)) '$D$(libdir)'
	cp -P $(foreach l,$(LIBRARIES),$(BUILD)/$(l).so.$(SOMAJOR) $(BUILD)/$(l).so) '$D$(libdir)'
	$(INSTALL) -m 644 $(HEADERS) '$D$(includedir)/sph2d'
	$(INSTALL) -m 644 $(MODULE_FILES) '$D$(pythondir)/sph2d'
	$(foreach l,$(LIBRARIES:lib%=%),$(pc_fill) src/$(l).pc.in | $(INSTALL) -m 644 /dev/stdin '$D$(pkgconfigdir)/$(l).pc' &&) true
	$(foreach f,sph2dConfig sph2dConfigVersion,$(cmake_fill) src/$(f).cmake.in | $(INSTALL) -m 644 /dev/stdin '$D$(cmakedir)/$(f).cmake' &&) true
	$(foreach p,$(MAN_PAGES),$(INSTALL) -m 644 $(p) '$(call man_dir,$(p))' &&) true
	$(INSTALL) -m 644 cli/completions/sph2d.bash '$D$(bashcompletiondir)/sph2d'
	$(INSTALL) -m 644 cli/completions/_sph2d '$D$(zshcompletiondir)'
	$(INSTALL) -m 644 $(SCHEMAS) '$D$(datadir)/sph2d'
	$(hush)$(foreach f,$(DOC_FILES),$(INSTALL) -m 644 $(f) '$D$(docdir)/$(f)' &&) true

# Those that the module loads, under the names by which it looks for them: a wheel has no links.
MODULE_LIBRARIES := $(filter-out libsph2d-study,$(LIBRARIES))
python-libraries: $(foreach l,$(MODULE_LIBRARIES),$(BUILD)/$(l).so) ## the shared libraries of the Python module into the folder TO, for pip
	$(INSTALL) -d '$(TO)'
	$(foreach l,$(MODULE_LIBRARIES),$(INSTALL) -m 755 $(BUILD)/$(l).so.$(VERSION) '$(TO)/$(l).so.$(SOMAJOR)' &&) true

uninstall: ## the reverse of install, with the same settings
	rm -f '$D$(bindir)/sph2d' $(foreach p,$(MAN_PAGES),'$(call man_dir,$(p))/$(notdir $(p))') \
	    $(foreach l,$(LIBRARIES),'$D$(libdir)/$(l).a' '$D$(libdir)/$(l).so' \
	    '$D$(libdir)/$(l).so.$(SOMAJOR)' '$D$(libdir)/$(l).so.$(VERSION)' \
	    '$D$(pkgconfigdir)/$(l:lib%=%).pc')
	rm -f '$D$(bashcompletiondir)/sph2d' '$D$(zshcompletiondir)/_sph2d'
	rm -rf '$D$(pythondir)/sph2d' '$D$(includedir)/sph2d' '$D$(cmakedir)' '$D$(docdir)' '$D$(datadir)/sph2d'

# ---- the rest --------------------------------------------------------------------------------------------------------
# The same bytes from the same commit: git takes its time for that of the files.
DIST := $(BUILD)/sph2d-$(VERSION).tar.xz
dist: ## a source archive of the last commit, BUILD/sph2d-VERSION.tar.xz
	$(hush)mkdir -p $(BUILD); \
	git -c tar.umask=0022 archive --format=tar --prefix=sph2d-$(VERSION)/ HEAD >$(BUILD)/dist.tar && \
	xz -9 --threads=1 --stdout $(BUILD)/dist.tar >$(DIST).new && rm $(BUILD)/dist.tar && mv $(DIST).new $(DIST)
	@echo '$(DIST)'

clean: ## remove BUILD
	rm -rf '$(BUILD)'

help: ## this list
	@sed -n 's/^\([a-z-]*\):[^=]*## \(.*\)/\1\t\2/p' Makefile | awk -F '\t' '{ printf "  make %-14s %s\n", $$1, $$2 }'
	@printf '%s\n' '' 'Settings: CC AR CPPFLAGS CFLAGS LDFLAGS LDLIBS' \
	    '  DESTDIR prefix bindir libdir includedir datadir mandir docdir pkgconfigdir bashcompletiondir' \
	    '  zshcompletiondir pythondir INSTALL PKG_CONFIG PYTHON' \
	    '  BUILD=build RENDER=0 OPENMP=0 SHARED=1 WERROR=1 SANITIZE=address,undefined V=1 DEPS=skip (never install packages)' \
	    '  CK_TIMEOUT_MULTIPLIER=5 (limits of time of tests, for a busy machine)'

.PHONY: all lib lib-core cli examples packages demo test golden test-same-bits test-device test-sanitize test-threads threads-run \
    test-valgrind test-ports test-foretold test-mutants test-full test-variants bench bench-command strangers strangers-dozen test-restarts \
    test-kills test-long test-recipes test-slurm test-hard hard-docs test-package test-faults test-fuzz fuzz-run coverage \
    coverage-run bench-instructions bench-variants bench-frames report report-full report-docs scene-docs python-docs gallery check-headers \
    check-symbols check-install check-lint check-walls format install python-libraries uninstall dist clean help FORCE
endif
