# The page: the library, the renderer and play, compiled by Emscripten into one HTML file that needs no server.
# Included by the Makefile.

WEB := $(BUILD)/web
EMCC ?= emcc
# Where Debian's Emscripten finds its helpers.
WEB_ENV := NODE_PATH=/usr/share/nodejs NODE_OPTIONS=
WEB_LIBS := $(WEB)/sources
# Snapshots are HDF5, which a page has no use for; absent.c refuses them, and drawings, which are files, and devices, whose
# OpenCL no browser has. Streamlines would take 3 of its 470 kB.
WEB_WITHOUT := src/files/drawing.c src/files/svg_% src/files/h5_% src/files/snapshot% src/files/parameters% src/files/series.c \
    src/device/% src/methods/common/on_device.c src/sim/device_steps.c src/render/streamlines.c src/render/png_file.c src/render/gl_context_egl.c src/render/gl_context_osmesa.c
WEB_SRC := $(filter-out $(WEB_WITHOUT),$(CORE_SRC) $(IO_SRC) $(CONTACTS_SRC) $(RENDER_SRC)) \
    cli/frame.c cli/frame_field.c cli/frame_paths.c cli/text.c cli/json.c $(addprefix cli/play/,camera.c drawn.c game.c grip.c hand.c keys.c lists.c live.c live_bodies.c \
        nozzle.c past.c quantities.c show.c sketch.c turn.c) \
    $(sort $(wildcard cli/web/*.c))
WEB_GEN := $(BUILD)/gen/shaders.c $(BUILD)/gen/play_scenes.c
WEB_OBJ := $(patsubst %.c,$(WEB)/obj/%.o,$(filter-out $(PASS_SRC),$(WEB_SRC)) $(WEB_GEN:$(BUILD)/%=%)) \
    $(PASS_SRC:%.c=$(WEB)/obj/%.baseline.o)
WEB_FLAGS := -std=c17 -D_POSIX_C_SOURCE=200809L -DNDEBUG -DSPH2D__SMALL -DSPH2D__NO_DEVICE -msimd128 -fno-math-errno -ffp-contract=off -MMD -MP \
    -Wno-unknown-pragmas -Wno-pass-failed -Iinclude -Isrc -Icli -I$(BUILD)/gen -I$(WEB)/headers \
    -I$(WEB_LIBS)/libfyaml/include -I$(WEB_LIBS)/chipmunk/include
# What takes the time of steps is compiled for speed, all else for size.
WEB_SLOW := src/methods/fitted/fitted_walls.c src/methods/methods.c src/methods/terms/friction.c src/methods/terms/stable_step.c \
    src/methods/terms/viscosity.c src/methods/projection/body_rows.c src/methods/wcsph/wcsph_bodies.c src/methods/common/profile.c src/methods/projection/limited_viscosity.c src/methods/muller/muller.c \
    src/particles/store.c
WEB_FAST := $(filter-out $(WEB_SLOW),$(filter src/particles/% src/methods/%,$(WEB_SRC)))
web_speed = $(if $(filter $(WEB_FAST),$(1)),-O3,-Oz)
WEB_LINK := -Os -sMALLOC=emmalloc -sMODULARIZE=1 -sEXPORT_NAME=makeModule -sENVIRONMENT=web -sFILESYSTEM=0 \
    -sALLOW_MEMORY_GROWTH=1 -sMIN_WEBGL_VERSION=2 -sMAX_WEBGL_VERSION=2 -sSUPPORT_LONGJMP=0 -sTOTAL_STACK=1MB \
    -sEXPORTED_RUNTIME_METHODS=UTF8ToString,stringToUTF8,lengthBytesUTF8 -sEXPORTED_FUNCTIONS=_malloc,_free

web: $(WEB)/index.html ## the page to play in a browser, BUILD/web/index.html

test-web: $(WEB)/index.html $(WEB)/state $(BUILD)/sph2d ## the page in a real Chromium (CHROMIUM=chromium)
	$(hush)CHROMIUM='$(or $(CHROMIUM),chromium)' node tests/web/page.js $(WEB)/index.html $(WEB)/state $(BUILD)/sph2d $(WEB)/test
$(WEB)/state: $(OBJ)/tests/web/state.o $(BUILD)/libsph2d-contacts.a $(BUILD)/libsph2d-io.a $(BUILD)/libsph2d.a
	$(call link,,$(CONTACTS_LIBS) $(IO_LIBS) $(CORE_LIBS))
$(OBJ)/tests/web/state.o: PART = -Iinclude
.PHONY: web test-web

web_compile = $(call say,EMCC,$<)mkdir -p $(@D) && $(WEB_ENV) $(EMCC) $(WEB_FLAGS) $(1) -c -o $@ $<

$(WEB_LIBS)/fetched: cli/web/sources.sh
	$(call say,GET,libfyaml and chipmunk)cli/web/sources.sh $(WEB_LIBS) && touch $@
# Headers of OpenGL without those of the system beside them; and what libfyaml's configure would find.
$(WEB)/headers/made: | $(WEB_LIBS)/fetched
	$(hush)mkdir -p $(@D)/GL $(@D)/KHR && gl=$$($(PKG_CONFIG) --variable=includedir $(firstword $(GL))) && \
	cp "$$gl"/GL/glcorearb.h $(@D)/GL && cp "$$gl"/KHR/khrplatform.h $(@D)/KHR && \
	printf '#define VERSION "%s"\n' "$$(sed -n 's/^AC_INIT.*/&/p' $(WEB_LIBS)/libfyaml/configure.ac | tr -dc 0-9.)" \
	    >$(@D)/config.h && touch $@
$(WEB_OBJ): | $(WEB)/headers/made
$(WEB)/obj/%_pass.baseline.o: %_pass.c
	$(call web_compile,-O3 -DSPH2D__ISA=baseline)
$(WEB)/obj/gen/%.o: $(BUILD)/gen/%.c
	$(call web_compile,-Os)
$(WEB)/obj/%.o: %.c
	$(call web_compile,$(call web_speed,$<))
# The two libraries as they are, each as one archive.
$(WEB)/libfyaml.a: $(WEB)/headers/made
	$(call say,EMCC,libfyaml)mkdir -p $(WEB)/obj/libfyaml && cd $(WEB)/obj/libfyaml && rm -f ./*.o && \
	$(WEB_ENV) $(EMCC) -Os -DNDEBUG -DHAVE_CONFIG_H -D_GNU_SOURCE -w -I$(abspath $(WEB)/headers) \
	    -I$(abspath $(WEB_LIBS))/libfyaml/include -I$(abspath $(WEB_LIBS))/libfyaml/src/xxhash \
	    -c $(abspath $(WEB_LIBS))/libfyaml/src/lib/*.c $(abspath $(WEB_LIBS))/libfyaml/src/xxhash/*.c && \
	$(WEB_ENV) emar qcs $(abspath $@) ./*.o
$(WEB)/libchipmunk.a: $(WEB)/headers/made
	$(call say,EMCC,chipmunk)mkdir -p $(WEB)/obj/chipmunk && cd $(WEB)/obj/chipmunk && rm -f ./*.o && \
	$(WEB_ENV) $(EMCC) -O2 -DNDEBUG -w -I$(abspath $(WEB_LIBS))/chipmunk/include \
	    -c $$(ls $(abspath $(WEB_LIBS))/chipmunk/src/*.c | grep -v Hasty) && \
	$(WEB_ENV) emar qcs $(abspath $@) ./*.o
$(WEB)/sph2d.js: $(WEB_OBJ) $(WEB)/libfyaml.a $(WEB)/libchipmunk.a cli/web/web.mk
	$(call say,LINK,$@)$(WEB_ENV) $(EMCC) $(WEB_LINK) -o $@ $(filter %.o %.a,$^)
$(WEB)/index.html: $(WEB)/sph2d.js cli/web/assemble.js cli/web/index.html cli/web/page.css cli/web/unpack.js $(wildcard cli/web/page*.js)
	$(call say,GEN,$@)node cli/web/assemble.js $@ $(WEB)/sph2d
-include $(shell test -d $(WEB)/obj && find $(WEB)/obj -name '*.d')
