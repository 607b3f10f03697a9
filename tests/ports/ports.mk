# The core on other machines, C libraries and compilers: the library and its tests, which need neither Check nor any other
# package. Included by the Makefile.

# What uses more than the core is left out; the list of suites is made of what is left.
CORE_TEST_SRC := $(filter-out tests/main.c,$(shell grep -L -E -e 'sph2d/(io|contacts|render|study|study_results)[.]h' \
    -e '"(contact_world|snapshot_fixture|splash|shaders)[.]h"' -e '"(study|contacts|render|files)/' \
    -e '<(hdf5|png|xxhash)[.]h>' $(sort $(wildcard tests/*.c)))) tests/ports/check_core.c
CORE_TEST_OBJ := $(CORE_TEST_SRC:%.c=$(OBJ)/core/%.o)
$(CORE_TEST_OBJ): PART = -isystem tests/ports -I$(BUILD)/gen -Itests $(CORE_FLAGS) -Wno-missing-prototypes
$(CORE_TEST_OBJ): | $(BUILD)/gen/core_suites.h
$(OBJ)/core/%.o: %.c
	$(call compile,$<)
$(BUILD)/gen/core_suites.h: $(CORE_TEST_SRC) tests/ports/ports.mk
	$(call say,GEN,$@)mkdir -p $(@D) && { printf '#define CORE_SUITES(X)'; \
	    sed -n 's/^Suite \*suite_\([a-z0-9_]*\)(.*/ X(\1)/p' $(filter tests/test_%,$(CORE_TEST_SRC)) | sort -u | tr -d '\n'; echo; } >$@
# The compilers for Windows give programs this ending.
EXE := $(if $(findstring mingw,$(MACHINE)),.exe)
$(BUILD)/tests/check_core$(EXE): $(CORE_TEST_OBJ) $(BUILD)/libsph2d.a $(BUILD)/variant
	$(call link,,$(CORE_LIBS))

CORE_SCENES_OBJ := $(OBJ)/tests/ports/core_scenes.o
$(CORE_SCENES_OBJ): PART = -Iinclude
$(BUILD)/tests/core_scenes$(EXE): $(CORE_SCENES_OBJ) $(BUILD)/libsph2d.a $(BUILD)/variant
	$(call link,,$(CORE_LIBS))
$(BUILD)/tests/embed$(EXE): $(OBJ)/examples/embed.o $(BUILD)/libsph2d.a $(BUILD)/variant
	$(call link,,$(CORE_LIBS))

-include $(CORE_TEST_OBJ:.o=.d) $(CORE_SCENES_OBJ:.o=.d)
