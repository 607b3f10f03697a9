# SPDX-License-Identifier: MIT
"""Simulate liquids in two dimensions: the libraries of sph2d, with NumPy views of their particles.

    import sph2d

    sim = sph2d.Simulation({"domain": {"min": [0, 0], "max": [1, 1]}, "spacing": 0.02,
                            "blocks": [{"box": {"min": [0, 0], "max": [0.4, 0.6]}}]})
    sim.run_to(0.5)
    print(sim.fluid.x.max(), sim.summary().compression_p99)

Scenes are dicts with the keys of scene files (sph2d-scene(5)), or the files themselves. All numbers are in SI units;
masses, forces and energies are per metre of depth.

Views. The arrays of Simulation.fluid, walls and field() are the library's own memory: nothing is copied, and they
cannot be written to. They show the particles of the moment at which they were taken, so take them again after every
step, and copy() what is to be kept. An old view never dangles, not after steps that need more memory nor after close():
the memory lives as long as a view of it. But after a step it may hold other particles, in another order, or another
quantity.

Threads. Calls release Python's lock, so that simulations run side by side in threads. One simulation is used by one
thread at a time: others wait for its step to end. HDF5 is not thread-safe; calls of this module that use it wait for
each other, but h5py, where it shares HDF5 with this module, must not be used by another thread at the same time.

The libraries are looked for in the folder that the environment variable SPH2D_LIBRARY_DIR names, and nowhere else if it
is set; else in the folders `lib` in this package and above it, as pip and `make install` put them; then by the system's
loader. libsph2d and libsph2d-io must be there, libsph2d-contacts for scenes with bodies, libsph2d-render for pictures.

Arguments. Numbers may be of any kind, as of NumPy, Decimal or Fraction; points are arrays, sequences or iterators of
them. What cannot be taken is refused by a TypeError or ValueError that names it, of scenes by the path of its key.
"""
from __future__ import annotations

import collections
import collections.abc
import ctypes
import functools
import json
import math
import operator
import os
import pathlib
import re
import reprlib
import sys
import sysconfig
import tempfile
import threading
import warnings
import weakref
from typing import (TYPE_CHECKING, Any, Dict, Iterable, List, Literal, Mapping, Optional, SupportsFloat, SupportsIndex,
                    Tuple, TypeVar, Union, overload)

import numpy as np

from . import _plots
from ._records import (BodyState, Boundary, Box, Densities, Device, Diagnostic, Plan, Sample, SnapshotInfo, Summary)

if TYPE_CHECKING:
    import pandas
    from matplotlib.axes import Axes
    from numpy.typing import ArrayLike, NDArray

    Number = Union[SupportsFloat, SupportsIndex]
    Numbers = Union[ArrayLike, Iterable[Any]]  # arrays, sequences, iterators, of any numbers
    Path = Union[str, bytes, "os.PathLike[str]", "os.PathLike[bytes]"]
    Changes = Optional[Mapping[str, Any]]
    Floats = NDArray[np.float64]

__all__ = ["BodyState", "Densities", "Device", "Diagnostic", "Error", "Particles", "Plan", "Renderer", "Sample",
           "Scene", "SceneWarning", "Simulation", "Snapshot", "SnapshotInfo", "Summary", "devices", "vorticity"]
__version__ = "0.1.0"

# ---- what is used of the headers -------------------------------------------------------------------------------------
# Declarations of C as they are in include/sph2d, which tests/python/test_layout.py lets the compiler compare with
# those.

_TYPES_TEXT = """
typedef enum sph2d_status { SPH2D_OK = 0, SPH2D_INVALID = 1 } sph2d_status;
typedef enum sph2d_code { SPH2D_CODE_GENERAL = 0 } sph2d_code;
typedef enum sph2d_severity { SPH2D_ERROR = 0, SPH2D_WARNING = 1 } sph2d_severity;
typedef enum sph2d_type { SPH2D_F64 = 0, SPH2D_U64 = 1 } sph2d_type;
typedef enum sph2d_group { SPH2D_GROUP_FLUID = 0, SPH2D_GROUP_WALL = 1, SPH2D_GROUP_RUN = 2,
    SPH2D_GROUP_OUTLINE = 3 } sph2d_group;
typedef enum sph2d_side { SPH2D_SIDE_WALL = 0 } sph2d_side;
typedef enum sph2d_switch { SPH2D_SWITCH_OFF = 0 } sph2d_switch;
typedef enum sph2d_shape_kind { SPH2D_SHAPE_BOX = 1, SPH2D_SHAPE_CIRCLE = 2, SPH2D_SHAPE_POLYGON = 3 } sph2d_shape_kind;
typedef enum sph2d_style { SPH2D_STYLE_METABALLS = 0, SPH2D_STYLE_POINTS = 1 } sph2d_style;
typedef enum sph2d_look { SPH2D_LOOK_WATER = 0 } sph2d_look;
typedef enum sph2d_background { SPH2D_BACKGROUND_OPAQUE = 0 } sph2d_background;
typedef enum sph2d_isa { SPH2D_ISA_AUTO = 0, SPH2D_ISA_BASELINE = 1, SPH2D_ISA_AVX2 = 2,
    SPH2D_ISA_AVX512 = 3 } sph2d_isa;
typedef enum sph2d_probe_kind { SPH2D_PROBE_ENERGY = 0 } sph2d_probe_kind;
typedef enum sph2d_key_kind { SPH2D_KEY_NUMBER = 0, SPH2D_KEY_COUNT = 1, SPH2D_KEY_COUNTS2 = 2, SPH2D_KEY_TEXT = 3,
    SPH2D_KEY_WORD = 4, SPH2D_KEY_POINT = 5, SPH2D_KEY_POINTS = 6, SPH2D_KEY_PATH = 7, SPH2D_KEY_POSES = 8,
    SPH2D_KEY_NUMBERS = 9, SPH2D_KEY_GROUP = 10, SPH2D_KEY_LIST = 11 } sph2d_key_kind;
typedef struct sph2d_vec2 { double x, y; } sph2d_vec2;
typedef struct sph2d_box { sph2d_vec2 min, max; } sph2d_box;
typedef struct sph2d_circle { sph2d_vec2 center; double radius; } sph2d_circle;
typedef struct sph2d_arc { sph2d_vec2 center; double radius; double from, to; } sph2d_arc;
typedef struct sph2d_points { const sph2d_vec2 *items; size_t count; } sph2d_points;
typedef struct sph2d_shape { sph2d_shape_kind kind; sph2d_box box; sph2d_circle circle; sph2d_points points;
    sph2d_arc arc; const char *svg; } sph2d_shape;
typedef struct sph2d_particle { double x, y; double vx, vy; double density; double color; } sph2d_particle;
typedef enum sph2d_material { SPH2D_MATERIAL_NONE = 0 } sph2d_material;
typedef enum sph2d_rheology { SPH2D_RHEOLOGY_NEWTONIAN = 0 } sph2d_rheology;
typedef struct sph2d_fluid { sph2d_material material; double density; double dynamic_viscosity; sph2d_rheology model;
    double consistency; double index; double yield_stress; double regularisation; double infinite_viscosity;
    double relaxation_time; double surface_tension; const char *color; } sph2d_fluid;
typedef struct sph2d_paths { size_t count; const double *places; const uint64_t *probes; } sph2d_paths;
typedef struct sph2d_rate { double per_second; double every; } sph2d_rate;
typedef struct sph2d_boundary { sph2d_side left, right, bottom, top; } sph2d_boundary;
typedef struct sph2d_frames { sph2d_rate rate; uint64_t size[2]; sph2d_style style; sph2d_look look;
    sph2d_background background; sph2d_box view; const char *follow; double radius; const char *color;
    sph2d_vec2 color_range; sph2d_switch arrows; double arrow_spacing; double arrow_speed; sph2d_switch streamlines;
    double streamline_spacing; const char *isolines; double isoline_step; sph2d_switch caption; } sph2d_frames;
typedef struct sph2d_diagnostic { sph2d_severity severity; sph2d_code code; char path[96]; char file[256];
    int line, column; char excerpt[160]; char message[320]; char hint[480]; } sph2d_diagnostic;
typedef struct sph2d_report { size_t count; size_t dropped; size_t errors; sph2d_diagnostic items[20]; } sph2d_report;
typedef struct sph2d_key { const char *name; sph2d_key_kind kind; bool required; size_t offset; size_t count_offset;
    double min, max; bool min_excluded; bool zero_is_unset; bool nan_is_unset; size_t choice_offset; int choice;
    const char *const *words; const struct sph2d_keys *keys; bool as_mapping; const char *unit;
    const char *default_text; const char *text; bool stands_alone; const char *also; int feature; void *preset; } sph2d_key;
typedef struct sph2d_keys { const sph2d_key *items; size_t count; size_t size; void *set_default; } sph2d_keys;
typedef struct sph2d_plan { size_t fluid_particles; size_t wall_particles; size_t places_left_free; double area_asked;
    double area_left_out; double most_left_out; size_t most_left_out_block; double area_placed; double particle_mass;
    double support_radius; double sound_speed; char sound_speed_formula[160]; double head; double capillary_head; double impact_compression;
    double time_step; const char *time_step_limit; double steps; double memory; double snapshots, frames;
    double disk; double disk_of_particle; } sph2d_plan;
typedef struct sph2d_allocator { void *resize; void *user; } sph2d_allocator;
typedef struct sph2d_device { char name[96]; char platform[64]; char driver[64]; bool gpu; bool same_bits;
    char lacks[64]; unsigned units; double memory; double largest; } sph2d_device;
typedef struct sph2d_sim_options { size_t struct_size; int threads; sph2d_isa isa; int device; bool same_bits;
    sph2d_allocator allocator; bool profile; } sph2d_sim_options;
typedef struct sph2d_view { size_t count; const double *x, *y; const double *vx, *vy; const double *ax, *ay;
    const double *density; const double *pressure; const uint64_t *id; } sph2d_view;
typedef struct sph2d_sample { double velocity[2]; double pressure; double density; double neighbours; } sph2d_sample;
typedef struct sph2d_body_state { sph2d_vec2 center; double angle; sph2d_vec2 velocity; double rate; sph2d_vec2 force;
    double torque; } sph2d_body_state;
typedef struct sph2d_summary { double time; uint64_t steps; uint64_t particle_steps; uint64_t particles;
    double compression_p99; double compression_mean; double compression_max; double kinetic, potential; double elastic;
    double energy_start; double energy_rise; double energy_error; double energy_error_rise; double energy_walls;
    double energy_forces; double energy_viscous; double energy_diffused; double energy_stopped; double bodies;
    double energy_contacts; double energy_pressed; double energy_scale; double kinetic_max; double density_apart;
    double energy_fed; double momentum[2]; double momentum_error[2], momentum_error_max; double momentum_moved;
    double speed_max; uint64_t paired; uint64_t fed, blocked; uint64_t drained; uint64_t let_in, let_out;
    uint64_t left_open[4]; uint64_t backstop_hits; uint64_t reflections; uint64_t iterations; uint64_t unconverged;
    uint64_t limited_by[4]; double time_step_min, time_step_max; double neighbours; } sph2d_summary;
typedef struct sph2d_densities { double reported; double counted; double covered; sph2d_status status; } sph2d_densities;
typedef struct sph2d_array { sph2d_group group; const char *name; const char *description; signed char unit[3];
    sph2d_type type; unsigned components; size_t count; size_t stride; const void *data[2]; } sph2d_array;
typedef struct sph2d_state { uint64_t version; const sph2d_array *arrays; size_t array_count; } sph2d_state;
typedef struct sph2d_override { const char *path, *value; } sph2d_override;
typedef struct sph2d_snapshot_info { const char *scene_name; const char *code_version; const char *method;
    const char *isa; const char *scene_text; double time; double time_step; uint64_t steps; sph2d_box domain;
    sph2d_boundary boundary; double spacing; double support_radius; double sound_speed;
    sph2d_fluid fluid; sph2d_frames frames; } sph2d_snapshot_info;
typedef struct sph2d_render_options { size_t struct_size; unsigned width, height; sph2d_style style; sph2d_look look;
    sph2d_background background; const char *gl; void *get_proc_address; const char *shader_dir; } sph2d_render_options;
typedef struct sph2d_picture { sph2d_box view; sph2d_box inside; double radius; size_t count; const double *x, *y;
    const double *values; double value_min, value_max; bool diverging; const uint64_t *colors; bool tinted; uint32_t tint;
    const char *value_label; double spacing;
    const double *vx, *vy; double arrow_spacing; double arrow_speed; const double *stream_vx, *stream_vy;
    double streamline_spacing; const double *level_values; double level_step; const char *level_label; size_t path_count;
    const double *path_x, *path_y; const uint64_t *path_id; size_t outline_count;
    const double *outline_x, *outline_y; const uint64_t *outline_id, *outline_liquid; double wall_thickness;
    const char *caption; const char *notes; } sph2d_picture;
"""

_VERSION_TEXT = "const char *sph2d_version(void);"

_FUNCTIONS_TEXT = {
    "sph2d": _VERSION_TEXT + """
const char *sph2d_status_name(sph2d_status status);
const char *sph2d_status_text(sph2d_status status);
const char *sph2d_code_text(sph2d_code code);
void sph2d_report_clear(sph2d_report *report);
size_t sph2d_diagnostic_format(const sph2d_diagnostic *diagnostic, char *buffer, size_t size);
const sph2d_keys *sph2d_scene_keys(void);
sph2d_status sph2d_scene_plan(const sph2d_scene *scene, sph2d_plan *plan, sph2d_report *report);
sph2d_sim_options sph2d_sim_options_default(void);
const char *sph2d_isa_name(sph2d_isa isa);
size_t sph2d_devices(sph2d_device *out, size_t room);
size_t sph2d_sim_device_memory(const sph2d_sim *sim);
sph2d_status sph2d_sim_create(const sph2d_scene *scene, const sph2d_sim_options *options, sph2d_sim **sim,
    sph2d_report *report);
sph2d_status sph2d_sim_restore(const sph2d_scene *scene, const sph2d_sim_options *options, const sph2d_state *state,
    sph2d_sim **sim, sph2d_report *report);
void sph2d_sim_destroy(sph2d_sim *sim);
sph2d_status sph2d_sim_step(sph2d_sim *sim, sph2d_report *report);
double sph2d_sim_time(const sph2d_sim *sim);
uint64_t sph2d_sim_steps(const sph2d_sim *sim);
double sph2d_sim_time_step(const sph2d_sim *sim);
sph2d_isa sph2d_sim_isa(const sph2d_sim *sim);
int sph2d_sim_threads(const sph2d_sim *sim);
size_t sph2d_sim_memory(const sph2d_sim *sim);
const sph2d_plan *sph2d_sim_plan(const sph2d_sim *sim);
const sph2d_scene *sph2d_sim_scene(const sph2d_sim *sim);
sph2d_allocator sph2d_shared_allocator(void);
void sph2d_shared_hold(const void *block);
void sph2d_shared_release(const void *block);
sph2d_state sph2d_sim_state(sph2d_sim *sim);
sph2d_view sph2d_sim_fluid(const sph2d_sim *sim);
sph2d_view sph2d_sim_walls(const sph2d_sim *sim);
size_t sph2d_field_count(sph2d_group group);
sph2d_status sph2d_vorticity(size_t count, const double *x, const double *y, const double *vx, const double *vy,
    double spacing, double *out, sph2d_report *report);
sph2d_array sph2d_field(const sph2d_sim *sim, sph2d_group group, size_t index);
const uint64_t *sph2d_sim_colors(const sph2d_sim *sim);
bool sph2d_fluid_color(const sph2d_fluid *fluid, uint32_t *rgb);
bool sph2d_color_parse(const char *text, uint32_t *rgb);
sph2d_paths sph2d_sim_paths(const sph2d_sim *sim);
bool sph2d_sim_sample(const sph2d_sim *sim, sph2d_vec2 at, sph2d_sample *out);
sph2d_status sph2d_sim_set_gravity(sph2d_sim *sim, sph2d_vec2 gravity);
sph2d_status sph2d_sim_set_pointer(sph2d_sim *sim, sph2d_vec2 at, double radius, double acceleration);
sph2d_status sph2d_sim_add_particles(sph2d_sim *sim, const sph2d_particle *particles, size_t count, size_t *added);
sph2d_status sph2d_sim_remove_particles(sph2d_sim *sim, const sph2d_shape *shape, size_t *removed);
sph2d_body_state sph2d_sim_body(const sph2d_sim *sim, size_t index);
sph2d_body_state sph2d_sim_obstacle(const sph2d_sim *sim, size_t index);
sph2d_status sph2d_sim_set_body_velocity(sph2d_sim *sim, size_t index, sph2d_vec2 velocity, double rate);
const char *sph2d_probe_columns(sph2d_probe_kind kind);
size_t sph2d_sim_probe(const sph2d_sim *sim, size_t index, double values[12]);
bool sph2d_sim_output_due(const sph2d_sim *sim, size_t output);
void sph2d_sim_output_done(sph2d_sim *sim, size_t output);
sph2d_summary sph2d_sim_summary(const sph2d_sim *sim);
sph2d_densities sph2d_sim_densities(const sph2d_sim *sim);
""",
    "sph2d-io": """
sph2d_status sph2d_scene_file_read(const char *path, const sph2d_override *overrides, size_t override_count,
    sph2d_scene_file **file, sph2d_report *report);
sph2d_status sph2d_scene_file_read_open(int descriptor, const char *name, const sph2d_override *overrides,
    size_t override_count, sph2d_scene_file **file, sph2d_report *report);
void sph2d_scene_file_destroy(sph2d_scene_file *file);
const sph2d_scene *sph2d_scene_file_scene(const sph2d_scene_file *file);
const char *sph2d_scene_file_text(const sph2d_scene_file *file);
void sph2d_scene_file_locate(const sph2d_scene_file *file, sph2d_diagnostic *diagnostic);
sph2d_status sph2d_snapshot_write(sph2d_sim *sim, const sph2d_scene_file *file, unsigned compress, const char *path,
    sph2d_report *report);
sph2d_status sph2d_snapshot_read(const char *path, sph2d_snapshot **snapshot, sph2d_report *report);
sph2d_status sph2d_snapshot_read_unchecked(const char *path, sph2d_snapshot **snapshot, sph2d_report *report);
void sph2d_snapshot_destroy(sph2d_snapshot *snapshot);
sph2d_snapshot_info sph2d_snapshot_get_info(const sph2d_snapshot *snapshot);
sph2d_state sph2d_snapshot_state(const sph2d_snapshot *snapshot);
const sph2d_array *sph2d_snapshot_array(const sph2d_snapshot *snapshot, sph2d_group group, const char *name);
sph2d_status sph2d_snapshot_scene(const sph2d_snapshot *snapshot, const sph2d_override *more, size_t more_count,
    sph2d_scene_file **file, sph2d_report *report);
""",
    "sph2d-contacts": "sph2d_status sph2d_contacts_attach(sph2d_sim *sim);",
    "sph2d-render": """
sph2d_render_options sph2d_render_options_default(void);
sph2d_status sph2d_renderer_create(const sph2d_render_options *options, sph2d_renderer **renderer,
    sph2d_report *report);
void sph2d_renderer_destroy(sph2d_renderer *renderer);
sph2d_status sph2d_renderer_draw(sph2d_renderer *renderer, const sph2d_picture *picture, sph2d_report *report);
const unsigned char *sph2d_renderer_pixels(const sph2d_renderer *renderer);
sph2d_status sph2d_renderer_write_png(sph2d_renderer *renderer, const char *path, sph2d_report *report);
""",
}

_TYPES = {"double": ctypes.c_double, "uint64_t": ctypes.c_uint64, "size_t": ctypes.c_size_t, "int": ctypes.c_int,
          "unsigned": ctypes.c_uint, "bool": ctypes.c_bool, "char": ctypes.c_char, "signed char": ctypes.c_byte,
          "uint32_t": ctypes.c_uint32, "void": None}
_BASE = r"((?:(?:const|struct|signed|unsigned) )*\w+) "
_DECLARATOR = r"((?:\*(?:const )?)*)(\w*)(?:\[(\d+)\])?"


def _type_of(base, stars):
    """The ctypes type of a C type. All pointers but those to texts are addresses."""
    base = base.replace("const ", "")
    if stars == "*" and base == "char":
        return ctypes.c_char_p
    return ctypes.c_void_p if stars else _TYPES[base]


def _members_of(body):
    """(name, type) of each member of a struct."""
    for member in filter(str.strip, body.split(";")):
        base, declarators = re.fullmatch(_BASE + "(.*)", " ".join(member.split())).groups()
        for declarator in declarators.split(", "):
            stars, name, length = re.fullmatch(_DECLARATOR, declarator).groups()
            kind = _type_of(base, stars)
            yield name, kind * int(length) if length else kind


def _declare_types(text):
    """Adds enums to _TYPES, their enumerators to _ENUM, and structs to both _TYPES and _STRUCT, without the prefix."""
    for what, name, body in re.findall(r"typedef (enum|struct) (\w+) \{(.*?)\} \2;", text, re.DOTALL):
        if what == "enum":
            _TYPES[name] = ctypes.c_int
            for constant in body.split(","):
                key, value = constant.split("=")
                _ENUM[key.strip()[len("SPH2D_"):]] = int(value)
        else:
            _TYPES[name] = type(name, (ctypes.Structure,), {"_fields_": list(_members_of(body))})
            _STRUCT[name[len("sph2d_"):]] = _TYPES[name]


def _declare_functions(library, text):
    """Sets arguments and result of the functions of a library that is loaded."""
    for base, stars, name, parameters in re.findall(_BASE + r"(\**)(\w+)\(([^)]*)\);", text):
        function = getattr(library, name)
        function.restype = _type_of(base, stars)
        arguments = []
        for parameter in () if parameters == "void" else parameters.split(","):
            base, declarator = re.fullmatch(_BASE + "(.*)", " ".join(parameter.split())).groups()
            stars, _, length = re.fullmatch(_DECLARATOR, declarator).groups()
            arguments.append(_type_of(base, stars or ("*" if length else "")))
        function.argtypes = arguments


_ENUM: Dict[str, int] = {}
_STRUCT: Dict[str, Any] = {}
_declare_types(_TYPES_TEXT)
_OK = _ENUM["OK"]
_OUTPUT_PROBE = 2  # SPH2D_OUTPUT_PROBE, of an enum without a name

# ---- the libraries ---------------------------------------------------------------------------------------------------

_PACKAGE = pathlib.Path(__file__).resolve().parent


def _find_folder():
    """The folder with libsph2d; None: the system's loader finds it."""
    given = os.environ.get("SPH2D_LIBRARY_DIR")
    if given:
        return pathlib.Path(given).absolute()
    below = ["", "lib", "lib64", "lib/" + (sysconfig.get_config_var("MULTIARCH") or "")]
    for parent in (_PACKAGE, *_PACKAGE.parents):
        for folder in below:
            if (parent / folder / "libsph2d.so.0").exists():
                return parent / folder
    return None


def _load(name):
    """A library with its functions declared. Errors: OSError, AttributeError for one that has not all of them,
    ImportError for another version."""
    file = f"lib{name}.so.0"
    library = ctypes.CDLL(str(_FOLDER / file) if _FOLDER else file)
    if name == "sph2d":
        _check_version(library)
    _declare_functions(library, _FUNCTIONS_TEXT[name])
    return library


def _check_version(library):
    _declare_functions(library, _VERSION_TEXT)
    version = library.sph2d_version().decode()
    # While the major number is 0, a new minor number may change the interface.
    if version.split(".")[:2] != __version__.split(".")[:2]:
        raise ImportError(f"the Python module {_PACKAGE} is of sph2d {__version__}, libsph2d in {_WHERE} of {version}: "
                          "install both from the same source, or set SPH2D_LIBRARY_DIR to the folder of the right "
                          "library")


def _load_core():
    """libsph2d and libsph2d-io. Errors: ImportError where they are missing or of another version."""
    try:
        core, files = _load("sph2d"), _load("sph2d-io")
    except OSError as error:
        raise ImportError(f"no libsph2d and libsph2d-io in {_WHERE}: {error}; install them with `make install`, or set "
                          "SPH2D_LIBRARY_DIR to their folder") from error
    except AttributeError as error:
        raise ImportError(f"libsph2d or libsph2d-io in {_WHERE} is older than the Python module {_PACKAGE}: {error}; "
                          "install both from the same source") from error
    if core.sph2d_sim_options_default().struct_size != ctypes.sizeof(_STRUCT["sim_options"]):
        raise ImportError(f"libsph2d in {_WHERE} has structs other than those of the Python module {_PACKAGE}: install "
                          "both from the same source")
    return core, files


def _load_optional(name, status, what):
    """A library that is only needed for something. Errors: Error, which says what for."""
    if name not in _LOADED:
        try:
            _LOADED[name] = _load(name)
        except (OSError, AttributeError) as error:
            raise _failure(status, f"no lib{name} in {_WHERE}, which is needed {what}: {error}") from error
    return _LOADED[name]


_FOLDER = _find_folder()
_WHERE = _FOLDER or "the folders of the system's loader"
_CORE, _IO = _load_core()
_LOADED: Dict[str, ctypes.CDLL] = {}
# libsph2d-io may be used by one thread at a time.
_IO_LOCK = threading.RLock()


def _status_texts():
    """Sentences for statuses, by name."""
    texts = {}
    while "UNKNOWN" not in texts:
        status = len(texts)
        texts[_CORE.sph2d_status_name(status).decode()] = _CORE.sph2d_status_text(status).decode()
    return texts


_STATUS_TEXTS = _status_texts()

# ---- errors ----------------------------------------------------------------------------------------------------------

class Error(Exception):
    """A call of the library failed. str() gives all sentences of its report.

    status: the library's, "SCENE", "GUARD", "NOINPUT", "FORMAT", "CANTCREAT", "IO", "RENDER", "INVALID", "NOMEM";
    diagnostics: tuple of Diagnostic, errors and warnings, in the order in which they were found; dropped: how many more
    there were than fit into a report, 20."""

    status: str
    diagnostics: Tuple[Diagnostic, ...]
    dropped: int

    def __init__(self, status: str, diagnostics: Tuple[Diagnostic, ...] = (), dropped: int = 0) -> None:
        super().__init__(status, diagnostics, dropped)
        self.status, self.diagnostics, self.dropped = status, diagnostics, dropped

    def __str__(self) -> str:
        lines = [diagnostic.text for diagnostic in self.diagnostics] or [_STATUS_TEXTS[self.status]]
        return "\n".join(lines + [f"and {self.dropped} more"] * (self.dropped > 0))


class SceneWarning(UserWarning):
    """Something in a scene that is allowed, but probably not meant; the text says what to do."""


def _failure(status, message):
    """An Error with a sentence of this module's own."""
    return Error(status, (Diagnostic("error", "G000", "", "", 0, 0, "", message, "", message),))


def _diagnostic(item):
    text = ctypes.create_string_buffer(_CORE.sph2d_diagnostic_format(ctypes.byref(item), None, 0) + 1)
    _CORE.sph2d_diagnostic_format(ctypes.byref(item), text, len(text))
    severity = "warning" if item.severity == _ENUM["WARNING"] else "error"
    return Diagnostic(severity, _CORE.sph2d_code_text(item.code).decode(), _python(item.path), _python(item.file),
                      item.line, item.column, _python(item.excerpt), _python(item.message), _python(item.hint),
                      _python(text.value))


def _warn(text):
    """Warns of what the caller of this module did."""
    frame, level = sys._getframe(), 1
    here = frame.f_code.co_filename
    while frame and frame.f_code.co_filename == here:
        frame, level = frame.f_back, level + 1
    warnings.warn(text, SceneWarning, stacklevel=level)


def _tell(status: int, report: Any, scene: Optional[Scene] = None) -> None:
    """Raises an Error if a call failed, else warns of what its report has; of each thing in a scene once."""
    if scene:
        with _IO_LOCK:
            for item in report.items[:report.count]:
                _IO.sph2d_scene_file_locate(scene._file, ctypes.byref(item))
    found = tuple(_diagnostic(item) for item in report.items[:report.count])
    if status != _OK:
        raise Error(_CORE.sph2d_status_name(status).decode(), found, report.dropped)
    told = scene._told if scene else set()
    for diagnostic in found:
        if (diagnostic.path, diagnostic.message) not in told:
            told.add((diagnostic.path, diagnostic.message))
            _warn(diagnostic.text)


# ---- values between C and Python -------------------------------------------------------------------------------------

# The named tuple of each struct that is handed out.
_RECORDS = {_STRUCT[name]: kind for name, kind in (
    ("summary", Summary), ("plan", Plan), ("body_state", BodyState), ("box", Box), ("boundary", Boundary),
    ("densities", Densities), ("snapshot_info", SnapshotInfo), ("device", Device))}


def _python(value):
    """A value of C as one of Python: points and arrays are tuples, structs are named tuples."""
    if isinstance(value, bytes):
        return value.decode(errors="replace")
    if isinstance(value, ctypes.Array):
        return tuple(value)
    if isinstance(value, _STRUCT["vec2"]):
        return value.x, value.y
    if type(value) in _RECORDS:
        record = _RECORDS[type(value)]
        return record(*(_python(getattr(value, name)) for name in record._fields))
    return value


# ---- what is given: taken, or refused by a sentence that names it ----------------------------------------------------

_REPR = reprlib.Repr()
_REPR.maxstring = _REPR.maxother = 80


def _shown(value):
    """What a sentence shows of a value that was given."""
    try:
        return " ".join(_REPR.repr(value).split())
    except ValueError:  # Python does not write integers of thousands of digits
        return "a number of thousands of digits"


def _plain(value):
    """An array, or what can be one, as lists, numbers and texts of Python; dates have no numbers of their own."""
    if hasattr(type(value), "__array__"):
        array = np.asarray(value)
        return value if array.dtype.kind in "mM" else array.tolist()
    return value


def _is_list(value):
    """Whether it has items in an order: a sequence or an iterator, but no text."""
    return isinstance(value, collections.abc.Iterable) and not isinstance(
        value, (str, bytes, bytearray, memoryview, collections.abc.Set, collections.abc.Mapping))


def _scalar(name, value, what="a number"):
    """A number of any kind as one of Python; infinite where it is beyond those of C. Errors: TypeError."""
    plain = _plain(value)
    try:
        if hasattr(type(plain), "__index__"):
            plain = operator.index(plain)
            float(plain)
            return plain
        if hasattr(type(plain), "__float__") and not isinstance(plain, (np.datetime64, np.timedelta64)):
            return float(plain)  # not of texts, which float() would read
    except OverflowError:
        return math.inf if plain > 0 else -math.inf
    except (TypeError, ValueError, ArithmeticError):  # it was no number, though it had the method
        pass
    raise TypeError(f"{name} must be {what}, not {_shown(value)}")


def _number(name, value):
    return float(_scalar(name, value))


def _finite(name, value):
    number = _number(name, value)
    if not math.isfinite(number):
        raise ValueError(f"{name} must be finite, not {_shown(value)}")
    return number


def _whole(name, value, low, high):
    """A whole number within limits; C would cut off what is beyond those of its type."""
    what = f"a whole number, {low} to {high}"
    number = _scalar(name, value, what)
    if not low <= number <= high or number % 1:
        raise (TypeError if number % 1 else ValueError)(f"{name} must be {what}, not {_shown(value)}")
    return int(number)


def _nested(name, value):
    """Lists of numbers."""
    if _is_list(value):
        return [_nested(f"{name}[{k}]", item) for k, item in enumerate(value)]
    return _number(name, value)


def _numbers(name, value, *shapes):
    """Numbers in arrays, sequences or iterators as an array of doubles that has one of some shapes, in which -1 stands
    for any length and ... for any lengths. Errors: ValueError for another shape; TypeError for what is no number."""
    try:
        array = np.asarray(value)
    except ValueError:  # rows of different lengths or kinds
        array = np.asarray(None)
    if array.dtype.kind == "O" and (_is_list(value) or () in shapes):
        try:
            array = np.asarray(_nested(name, _plain(value)), float)
        except (ValueError, RecursionError):
            pass
    found = array.dtype.kind in "biuf"
    if found:
        if array.shape == (0,) and len(shapes[0]) == 2:
            array = array.reshape(0, 2)  # no points
        for shape in shapes:
            if shape[:1] == (...,) and array.shape[-1:] == shape[1:] or len(shape) == array.ndim and all(
                    wanted in (-1, length) for wanted, length in zip(shape, array.shape)):
                return np.asarray(array, float, "C")
    texts = " or ".join(str(shape).replace("Ellipsis", "...").replace("-1", "n") for shape in shapes)
    raise ValueError(f"{name} must be numbers of shape {texts}, not {f'of {array.shape}' if found else _shown(value)}")


def _vec2(name, point):
    return _STRUCT["vec2"](*_numbers(name, point, (2,)).tolist())


def _flag(name, value):
    plain = _plain(value)
    if not isinstance(plain, int) or plain not in (0, 1):
        raise TypeError(f"{name} must be True or False, not {_shown(value)}")
    return bool(plain)


def _choice(name, value, choices):
    if not isinstance(value, str) or value not in choices:
        raise ValueError(f"{name} is one of {', '.join(choices)}, not {_shown(value)}")
    return value


def _text(name, value):
    """A text for C, where a zero byte would end it; None for none."""
    if value is not None and (not isinstance(value, str) or "\0" in value):
        raise TypeError(f"{name} must be a text without zero bytes, not {_shown(value)}")
    return None if value is None else value.encode("utf-8", "replace")


def _path_bytes(name, path, what="the name of a file"):
    """The name of a file for C."""
    try:
        made = os.fsencode(path)
    except (TypeError, ValueError) as error:
        raise TypeError(f"{name} must be {what}, not {_shown(path)}") from error
    if b"\0" in made:
        raise ValueError(f"{name} must be {what}, which has no zero byte")
    return made


def _key_text(key):
    """A key; one that is no text is refused as an unknown one, but for what readers of YAML 1.1 make of `on`."""
    return key if isinstance(key, str) else "on" if key is True else _shown(key)


def _json(value, path, indent=""):
    """A value of a key as JSON, a key per line, so that a message shows the line of its key."""
    value, inner = _plain(value), indent + " "
    if value is None or isinstance(value, (str, float)):
        return json.dumps(value)
    if isinstance(value, bool):
        return '"on"' if value else '"off"'
    if isinstance(value, os.PathLike):
        return json.dumps(os.fsdecode(_path_bytes(path, value)))
    if isinstance(value, collections.abc.Mapping):
        texts = ((_key_text(key), item) for key, item in value.items())
        items = [f"{json.dumps(key)}: {_json(item, f'{path}.{key}' if path else key, inner)}" for key, item in texts]
        return "{\n" + inner + f",\n{inner}".join(items) + f"\n{indent}}}" if items else "{}"
    if _is_list(value):
        return "[" + ", ".join(_json(item, f"{path}[{k}]", inner) for k, item in enumerate(value)) + "]"
    return json.dumps(_scalar(path, value, "a number, a text, a list or a dict"))


def _json_bytes(value, path=""):
    """Errors: TypeError, which names the key, for what is no value of one; ValueError for endless nesting."""
    try:
        return _json(value, path).encode()
    except RecursionError:
        raise ValueError(f"{path or 'the scene'} is nested too deeply, or in itself") from None


def _overrides(changes):
    if not isinstance({} if changes is None else changes, collections.abc.Mapping):
        raise TypeError(f"set must be a dict from paths of keys to values, not {_shown(changes)}")
    changes = [(_key_text(key), value) for key, value in (changes or {}).items()]
    if any("\0" in key for key, _ in changes):
        raise ValueError("a path of a key in `set` has no zero byte")
    return (_STRUCT["override"] * len(changes))(*((key.encode(errors="backslashreplace"), _json_bytes(value, key))
                                                  for key, value in changes))


# ---- arrays and records of the library -------------------------------------------------------------------------------


class _Borrowed:
    """Memory of an owner as a read-only array of NumPy, which keeps the owner alive."""

    def __init__(self, owner, kind, address, count, stride=1):
        self.owner = owner
        self.__array_interface__ = {"version": 3, "typestr": kind, "shape": (count,), "strides": (8 * stride,),
                                    "data": (address, True)}


_F64, _U64 = np.dtype(np.float64).str, np.dtype(np.uint64).str


def _copy(kind, address, count, stride=1):
    """`count` values, or one for all where the stride is 0, that cannot be written to."""
    values = np.frombuffer(ctypes.string_at(address, 8 * (count if stride else 1)) if count else b"", kind)
    return values if stride or not count else np.broadcast_to(values, count)


def _group(name, *names):
    """A group, of some names only where they are given."""
    groups = {"fluid": _ENUM["GROUP_FLUID"], "wall": _ENUM["GROUP_WALL"], "run": _ENUM["GROUP_RUN"],
              "outline": _ENUM["GROUP_OUTLINE"]}
    return groups[_choice("group", name, names or groups)]


# Names of fields that have two.
_Pairs = Literal["Coordinates", "Velocities", "Accelerations", "StrainRates", "OldAccelerations"]


def _components(array, view):
    """The array of an sph2d_array, or a tuple of two. view(kind, address, count, stride) makes them."""
    kind = _U64 if array.type == _ENUM["U64"] else _F64
    made = tuple(view(kind, address, array.count, array.stride) for address in array.data[:array.components])
    return made if len(made) > 1 else made[0]


class Particles:
    """Particles, one value each, as arrays that cannot be written to. len() is their number.

    x, y: position [m]; vx, vy: velocity [m/s]; ax, ay: acceleration [m/s^2], None for walls; density [kg/m^3]; pressure
    [Pa]; id: a particle's permanent number; color: 65536 red + 256 green + blue, in scenes that give one. None stands for
    what there is not."""

    __slots__ = ("x", "y", "vx", "vy", "ax", "ay", "density", "pressure", "id", "color")
    x: Floats
    y: Floats
    vx: Floats
    vy: Floats
    ax: Optional[Floats]
    ay: Optional[Floats]
    density: Floats
    pressure: Floats
    id: NDArray[np.uint64]
    color: Optional[NDArray[np.uint64]]

    def __init__(self, **arrays: Optional[NDArray[Any]]) -> None:
        for name in self.__slots__:
            setattr(self, name, arrays.get(name))

    def __len__(self) -> int:
        return 0 if self.x is None else len(self.x)

    def __repr__(self) -> str:
        return f"<sph2d.Particles: {len(self)}>"


# ---- scenes ----------------------------------------------------------------------------------------------------------


def _keys_at(address):
    keys = _STRUCT["keys"].from_address(address)
    return list((_STRUCT["key"] * keys.count).from_address(keys.items))


def _words_of(key):
    words = []
    while ctypes.c_char_p.from_address(key.words + 8 * len(words)).value is not None:
        words.append(ctypes.c_char_p.from_address(key.words + 8 * len(words)).value.decode())
    return words


def _key_at(path):
    """A key by its path, "run.frames.style"."""
    address = _CORE.sph2d_scene_keys()
    for name in path.split("."):
        key = next(key for key in _keys_at(address) if key.name.decode() == name)
        address = key.keys
    return key


@functools.lru_cache(maxsize=None)
def _words(path):
    """The words of a key."""
    return _words_of(_key_at(path))


# Numbers of an item of a list, by kind.
_WIDTHS = {_ENUM["KEY_POINTS"]: 2, _ENUM["KEY_PATH"]: 3, _ENUM["KEY_POSES"]: 4, _ENUM["KEY_NUMBERS"]: 1}


def _list_value(key, owner):
    """The value of a key of a list kind in the struct at address `owner`."""
    items = ctypes.c_void_p.from_address(owner + key.offset).value
    count = ctypes.c_size_t.from_address(owner + key.count_offset).value if items else 0
    if key.kind == _ENUM["KEY_LIST"]:
        size = _STRUCT["keys"].from_address(key.keys).size
        return [_group_value(key.keys, items + k * size) for k in range(count)]
    width = _WIDTHS[key.kind]
    numbers = list((ctypes.c_double * (count * width)).from_address(items)) if count else []
    return numbers if width == 1 else [tuple(numbers[k:k + width]) for k in range(0, count * width, width)]


def _key_value(key, owner):
    """The value of a key in the struct at address `owner`; None: not given."""
    at = owner + key.offset
    if key.kind == _ENUM["KEY_GROUP"]:
        return _group_value(key.keys, at)
    if key.kind == _ENUM["KEY_TEXT"]:
        text = ctypes.c_char_p.from_address(at).value
        return None if text is None else _python(text)
    if key.kind == _ENUM["KEY_WORD"]:
        return _words_of(key)[ctypes.c_int.from_address(at).value]
    if key.kind == _ENUM["KEY_COUNTS2"]:
        return tuple((ctypes.c_uint64 * 2).from_address(at))
    if key.kind == _ENUM["KEY_POINT"]:
        point = _python(_STRUCT["vec2"].from_address(at))
        return None if key.nan_is_unset and math.isnan(point[0]) else point
    if key.kind in (_ENUM["KEY_NUMBER"], _ENUM["KEY_COUNT"]):
        number = (ctypes.c_double if key.kind == _ENUM["KEY_NUMBER"] else ctypes.c_uint64).from_address(at).value
        unset = key.nan_is_unset and math.isnan(number) or key.zero_is_unset and number == 0
        return None if unset else number
    return _list_value(key, owner)


def _group_value(keys, owner):
    chosen = (key for key in _keys_at(keys)
              if key.choice == 0 or ctypes.c_int.from_address(owner + key.choice_offset).value == key.choice)
    return {key.name.decode(): _key_value(key, owner) for key in chosen}


def _own(owner, destroy, address):
    """Has `destroy` called for what the library made, when `owner` is gone; at the end of the process not at all, as
    other threads may be using it."""
    finalizer = weakref.finalize(owner, destroy, address)
    finalizer.atexit = False
    return finalizer


_T = TypeVar("_T")
_Sim = TypeVar("_Sim", bound="Simulation")


class _Owner:
    """Owns memory of the library. A copy by attributes would free it, too, so copy and pickle are refused by a sentence
    of the class, where it does not say how to make one."""

    def __reduce__(self):
        raise TypeError(self._no_copy)


class _Unchanging(_Owner):
    """An owner of what never changes: it is its own copy, as a tuple is."""

    def __copy__(self: _T) -> _T:
        return self

    def __deepcopy__(self: _T, _memo: object) -> _T:
        return self


def _destroy_scene(file):
    with _IO_LOCK:
        _IO.sph2d_scene_file_destroy(file)


def _destroy_snapshot(snapshot):
    with _IO_LOCK:
        _IO.sph2d_snapshot_destroy(snapshot)


class Scene(_Unchanging):
    """A scene that was read and checked.

    source: a dict (any mapping) with the keys of a scene file, or the name of a scene file. Values of a dict are what
    YAML has: numbers, texts, lists, dicts; tuples, iterators, arrays of NumPy, paths and True and False (for on and
    off) are taken, too. Files that it names are relative to the current folder, those of a scene file to its folder.
    set: a dict of changes on top, from paths of keys to values: {"fluid.density": 900, "blocks[0].velocity": [1, 0]}.

    A scene does not change, so copy.copy() gives the scene itself; it cannot be pickled, what it is made of can.

    Errors: Error with status SCENE, with every fault of the scene; NOINPUT; NOMEM. Warns with SceneWarning."""

    _no_copy = "a Scene cannot be pickled: pickle the dict or the name of the file that it is made of"

    def __init__(self, source: Union[Mapping[str, Any], Path], set: Changes = None) -> None:
        changes, report, file = _overrides(set), _STRUCT["report"](), ctypes.c_void_p()
        rest = changes, len(changes), ctypes.byref(file), ctypes.byref(report)
        is_dict = isinstance(source, collections.abc.Mapping)
        given = _json_bytes(source) if is_dict else _path_bytes("source", source, "a dict, or the name of a scene file")
        with _IO_LOCK:
            if is_dict:
                with open(os.memfd_create("scene"), "w+b", buffering=0) as text:
                    text.write(given)
                    text.seek(0)
                    status = _IO.sph2d_scene_file_read_open(text.fileno(), b"scene", *rest)
            else:
                status = _IO.sph2d_scene_file_read(given, *rest)
        self._take(file.value, status, report)

    def _take(self, file, status, report):
        self._told = set()
        if status == _OK:
            self._file = file
            _own(self, _destroy_scene, file)
            with _IO_LOCK:
                self._address = _IO.sph2d_scene_file_scene(file)
        _tell(status, report, self if status == _OK else None)

    @property
    def text(self) -> str:
        """The text as it was read; of a dict as JSON."""
        with _IO_LOCK:
            return _python(_IO.sph2d_scene_file_text(self._file))

    def as_dict(self) -> Dict[str, Any]:
        """Every key of the scene as a nested dict, with its default where it was not given; None: no value, the method
        derives one or does without. Of keys that exclude each other only the one that is given. What files gave is
        in place of their names, for motions and histories."""
        return _group_value(_CORE.sph2d_scene_keys(), self._address)

    def plan(self) -> Plan:
        """Size and derived parameters: a Plan. Places the particles to make it. Errors: Error with status SCENE,
        NOMEM."""
        plan, report = _STRUCT["plan"](), _STRUCT["report"]()
        status = _CORE.sph2d_scene_plan(self._address, ctypes.byref(plan), ctypes.byref(report))
        _tell(status, report, self)
        return _python(plan)


# ---- simulations -----------------------------------------------------------------------------------------------------


class _Block(_Owner):
    """A block of a simulation's memory, which lives at least as long as this."""

    _no_copy = "the memory of a view cannot be copied: copy() the array"

    def __init__(self, address):
        _CORE.sph2d_shared_hold(address)
        self.address = address

    def __del__(self, _release=_CORE.sph2d_shared_release):
        _release(self.address)


class _Pictured:
    """What has particles that can be drawn."""

    def _repr_png_(self) -> Optional[bytes]:
        """The picture that a notebook shows: a frame, as run.frames of the scene says; None where none can be drawn."""
        if getattr(self, "_sim", self) is None:  # closed
            return None
        try:
            return _frame_png(self)
        except Error as error:
            if error.status == "RENDER":
                return None
            raise

    def plot(self, color: Optional[str] = "speed", axes: Optional[Axes] = None, **options: Any) -> Axes:
        """Plots the liquid and the outlines of walls and bodies with Matplotlib, and returns the axes.

        color: the quantity that colours the particles, as of run.frames.color: "speed", the default, "vorticity",
        "Pressures", "Densities"; None: the colours of the liquid. axes: those to draw into; default None: of a new figure. options:
        what a collection of Matplotlib takes, cmap="magma", clim=(0, 2), alpha=0.5. Colours without a clim go from
        the 1st to the 99th percentile, as in frames. Errors: ImportError where Matplotlib is missing; ValueError for
        another quantity."""
        return _plot(self, color, axes, options)


class Simulation(_Pictured, _Owner):
    """A simulation: its scene, its particles, its clock.

    source, set: a Scene, or what makes one. threads: number of threads, 1 to 1024; default 0: what OpenMP says
    (OMP_NUM_THREADS, else the processors that the process may use), at most one for 512 particles; results are the same
    bits for any number. isa: instruction set, "baseline",
    "avx2" or "avx512"; default "auto": the widest that the processor has.

    device: what takes the steps, a number of devices(), from 1 on; default 0: the processor. same_bits: only a device that
    has the bits of the processor's "baseline", which is the isa of all devices; default False. Drivers have threads, which
    a process forked later lacks: use multiprocessing's "spawn". Copies are on the same device.

    contacts: whether bodies meet each other and walls (libsph2d-contacts), default True; False: they pass through each
    other and through walls.

    Memory is freed with the last reference to it, or by close(); a simulation is a context manager, too. Afterwards all
    calls raise ValueError. copy.copy() and copy.deepcopy() make an independent simulation that goes on from here, bit
    for bit; so does pickle, as by write_snapshot() and Snapshot.resume(). Errors: as of Scene, and Error with status
    INVALID, NOMEM, DEVICE; ValueError for other threads or an unknown isa. Warns with SceneWarning."""

    def __init__(self, source: Union[Scene, Mapping[str, Any], Path], set: Changes = None, *, threads: Number = 0,
                 isa: str = "auto", device: Number = 0, same_bits: bool = False, contacts: bool = True) -> None:
        if isinstance(source, Scene) and _overrides(set):
            raise TypeError("`set` changes a scene as it is read: Scene(source, set)")
        self._create(source if isinstance(source, Scene) else Scene(source, set), None, isa,
                     (threads, contacts, device, same_bits))

    def _create(self, scene, state, isa, given):
        self._scene, self._keys, self._sim = scene, scene.as_dict(), None
        threads, contacts, device, same_bits = given
        self._options = (_whole("threads", threads, 0, 1024), _flag("contacts", contacts),
                         _whole("device", device, 0, 1000), _flag("same_bits", same_bits))
        self._lock, self._report = threading.RLock(), _STRUCT["report"]()
        options = _CORE.sph2d_sim_options_default()
        options.threads, options.isa = self._options[0], _isa_of(isa)
        options.device, options.same_bits = self._options[2:]
        options.allocator = _CORE.sph2d_shared_allocator()
        function, from_state = _CORE.sph2d_sim_create, ()
        if state is not None:
            function, from_state = _CORE.sph2d_sim_restore, (ctypes.byref(state),)
        made = ctypes.c_void_p()
        try:
            status = function(scene._address, ctypes.byref(options), *from_state, ctypes.byref(made),
                              ctypes.byref(self._report))
        finally:  # Ctrl-C is raised after the call
            if made:
                self._sim, self._destroy = made.value, _own(self, _CORE.sph2d_sim_destroy, made.value)
        _tell(status, self._report, scene)
        if self._options[1] and self._keys["bodies"]:
            what = "for contacts of bodies (contacts=False does without)"
            library = _load_optional("sph2d-contacts", "INVALID", what)
            library.sph2d_contacts_attach(self._sim)
        self._rows = [[] for _ in self._keys["probes"]]
        if state is None:  # what goes on has them
            self._record()

    # -- its life

    def close(self) -> None:
        """Frees the simulation; views that were taken stay as they are. Twice is fine."""
        with self._lock:
            if self._sim:
                self._sim = None
                self._destroy()

    def __enter__(self: _Sim) -> _Sim:
        return self

    def __exit__(self, *_: object) -> None:
        self.close()

    def __repr__(self) -> str:
        if not self._sim:
            return "<sph2d.Simulation, closed>"
        return f"<sph2d.Simulation of {self._keys['name']!r}: {len(self.fluid)} particles, t = {self.time:g} s>"

    def __copy__(self: _Sim) -> _Sim:
        made = type(self).__new__(type(self))
        made.__dict__.update(self.__dict__)  # what others have added
        with self._lock:
            state = self._get(_CORE.sph2d_sim_state)
            if state.array_count == 0:
                raise Error("NOMEM")
            made._create(self._scene, state, "auto", self._options)
            made._rows = [list(rows) for rows in self._rows]
        return made

    def __deepcopy__(self: _Sim, _memo: object) -> _Sim:
        return self.__copy__()

    def __reduce__(self):
        with tempfile.TemporaryDirectory() as folder:
            path = pathlib.Path(folder, "state.h5")
            self.write_snapshot(path)
            return _resumed, (type(self), path.read_bytes(), self._options), {"_rows": self._rows}

    def _get(self, function, *arguments):
        """Calls a function of the library with the simulation."""
        with self._lock:
            if not self._sim:
                raise ValueError("the simulation is closed")
            return function(self._sim, *arguments)

    def _steer(self, message, function, *arguments):
        status = self._get(function, *arguments)
        if status == _ENUM["INVALID"]:
            raise _failure("INVALID", message)
        if status != _OK:
            raise Error(_CORE.sph2d_status_name(status).decode())

    # -- steps

    def step(self) -> None:
        """Advances by one time step. Errors: Error with status GUARD when a guard stops the run (the particles stay as
        they are, and every later step fails the same way), NOMEM."""
        with self._lock:
            _CORE.sph2d_report_clear(ctypes.byref(self._report))
            status = self._get(_CORE.sph2d_sim_step, ctypes.byref(self._report))
            if status == _OK:
                self._record()
            if status != _OK or self._report.count:
                _tell(status, self._report, self._scene)

    def run_to(self, time: Number) -> None:
        """Steps until the time [s] is reached; the last step may pass it. Errors: as of step(); ValueError if the time
        is not finite."""
        end = _finite("time", time)
        while self.time * (1 + 1e-12) < end:  # as `sph2d run` ends
            self.step()

    def advance(self, duration: Number) -> None:
        """Steps for a duration [s]: run_to(time + duration)."""
        self.run_to(self.time + _finite("duration", duration))

    # -- what it is

    @property
    def time(self) -> float:
        """Simulated time [s]."""
        return self._get(_CORE.sph2d_sim_time)

    @property
    def steps(self) -> int:
        """Steps taken."""
        return self._get(_CORE.sph2d_sim_steps)

    @property
    def time_step(self) -> float:
        """Length of the next step [s]."""
        return self._get(_CORE.sph2d_sim_time_step)

    @property
    def threads(self) -> int:
        """The number of threads that the next step asks OpenMP for."""
        return self._get(_CORE.sph2d_sim_threads)

    @property
    def isa(self) -> str:
        """The instruction set in use, "avx2"."""
        return _CORE.sph2d_isa_name(self._get(_CORE.sph2d_sim_isa)).decode()

    @property
    def memory(self) -> int:
        """Memory allocated [bytes]."""
        return self._get(_CORE.sph2d_sim_memory)

    @property
    def device_memory(self) -> int:
        """Memory in use on its device [bytes], most of it from the first step on; 0 on the processor."""
        return self._get(_CORE.sph2d_sim_device_memory)

    @property
    def plan(self) -> Plan:
        """The Plan of the scene when the simulation was created."""
        with self._lock:
            return _python(_STRUCT["plan"].from_address(self._get(_CORE.sph2d_sim_plan)))

    @property
    def scene(self) -> Scene:
        """The Scene."""
        return self._scene

    def summary(self) -> Summary:
        """Totals and errors of the run so far: a Summary."""
        return _python(self._get(_CORE.sph2d_sim_summary))

    def densities(self) -> Densities:
        """The Densities now. Takes the time of a few steps. Errors: Error with status NOMEM."""
        made = self._get(_CORE.sph2d_sim_densities)
        if made.status != _OK:
            raise Error(_CORE.sph2d_status_name(made.status).decode())
        return _python(made)

    # -- particles

    def _view(self, kind, address, count, stride=1):
        if not address:
            return None
        if count == 0 or stride == 0:  # one value for all is inside a struct
            return _copy(kind, address, count, stride)
        return np.asarray(_Borrowed(_Block(address), kind, address, count))

    def _particles(self, function):
        with self._lock:
            view = self._get(function)
            arrays = {name: self._view(_U64 if name == "id" else _F64, getattr(view, name), view.count)
                      for name in Particles.__slots__ if name != "color"}
            colors = self._get(_CORE.sph2d_sim_colors) if function == _CORE.sph2d_sim_fluid else None
            return Particles(color=self._view(_U64, colors, view.count), **arrays)

    @property
    def fluid(self) -> Particles:
        """The particles of the liquid now: Particles, whose arrays are views (see the module)."""
        return self._particles(_CORE.sph2d_sim_fluid)

    @property
    def walls(self) -> Particles:
        """The boundary particles now, like `fluid`."""
        return self._particles(_CORE.sph2d_sim_walls)

    @overload
    def field(self, name: _Pairs, group: str = "fluid") -> Tuple[Floats, Floats]: ...  # type: ignore[overload-overlap]

    @overload
    def field(self, name: str, group: str = "fluid") -> NDArray[Any]: ...

    def field(self, name: str, group: str = "fluid") -> Any:
        """A field by its name in snapshots, "Pressures", of a group "fluid" or "wall": a view (see the module); of
        points a tuple of two. Of group "outline", the corners of walls and bodies now, it is a copy. Errors: KeyError,
        which lists the names; ValueError for another group."""
        group = _group(group, "fluid", "wall", "outline")
        view = _copy if group == _ENUM["GROUP_OUTLINE"] else self._view
        with self._lock:
            fields = [self._get(_CORE.sph2d_field, group, k) for k in range(_CORE.sph2d_field_count(group))]
            for field in fields:
                if isinstance(name, str) and field.name.decode() == name:
                    return _components(field, view)
        raise KeyError(f"{_shown(name)} is not one of {', '.join(field.name.decode() for field in fields)}")

    def sample(self, points: Numbers) -> Sample:
        """The liquid at points [m], shape (..., 2): a Sample, of third order inside liquid. Errors: ValueError for
        another shape."""
        places = _numbers("points", points, (..., 2))
        flat = places.reshape(-1, 2)
        out = np.empty((len(flat), 5))
        with self._lock:
            for k, (x, y) in enumerate(flat.tolist()):
                self._get(_CORE.sph2d_sim_sample, _STRUCT["vec2"](x, y), out.ctypes.data + 40 * k)
        out = out.reshape(*places.shape[:-1], 5)
        return Sample(out[..., :2], *(out[..., k][()] for k in (2, 3, 4)))

    # -- steering

    def set_gravity(self, gravity: Numbers) -> None:
        """Sets gravity (x, y) [m/s^2] from the next step on. Errors: Error with status INVALID when not finite."""
        self._steer("gravity must be finite", _CORE.sph2d_sim_set_gravity, _vec2("gravity", gravity))

    def set_pointer(self, at: Numbers, radius: Number, acceleration: Number) -> None:
        """Attracts liquid within a radius [m] to a point [m] by an acceleration [m/s^2], or repels it if that is
        negative; 0 ends it. Errors: Error with status INVALID for values that are not finite or out of range."""
        self._steer("the pointer needs a finite place and acceleration, and a radius above 0",
                    _CORE.sph2d_sim_set_pointer, _vec2("at", at), _number("radius", radius),
                    _number("acceleration", acceleration))

    def add_particles(self, points: Numbers, velocity: Numbers = (0, 0), density: Union[Number, Numbers] = 0,
                      color: Union[str, Number, Numbers] = 0) -> int:
        """Adds liquid at points [m], shape (n, 2), where there is room: in the domain, 0.75 spacings from other
        particles and from walls, in no solid. velocity [m/s] and density [kg/m^3], 0 for rest density, are those of all
        or of shape (n, 2) and (n,). color, in scenes that give one: a name or "#rrggbb", or numbers as of
        Particles.color, 0 for the fluid's. Returns how many were added; they count as `fed`. Errors: ValueError for
        other shapes and colours; Error with status INVALID for values that are not finite or out of range, GUARD,
        NOMEM."""
        places, added = _numbers("points", points, (-1, 2)), ctypes.c_size_t()
        rows, count = np.empty((len(places), 6)), len(places)
        rows[:, :2], rows[:, 2:4] = places, _numbers("velocity", velocity, (count, 2), (2,))
        rows[:, 4] = _numbers("density", density, (count,), ())
        rows[:, 5] = _numbers("color", _color(color) if isinstance(color, str) else color, (count,), ())
        self._steer("particles need finite places and velocities, densities that are finite and not below 0, and colours "
                    "from 0 to 16777215",
                    _CORE.sph2d_sim_add_particles, rows.ctypes.data, len(rows), ctypes.byref(added))
        return added.value

    def remove_particles(self, shape: Mapping[str, Any]) -> int:
        """Removes the liquid in a shape, written as that of a drain: {"box": {"min": [0, 0], "max": [1, 1]}},
        {"circle": {"center": [0, 0], "radius": 1}} or {"polygon": [[0, 0], [1, 0], [0, 1]]} [m]. Returns how many
        particles were removed; they count as `drained`. Errors: ValueError for another shape; Error with status
        INVALID for values that are not finite or out of range, GUARD, NOMEM."""
        made, _corners = _shape(shape)
        removed = ctypes.c_size_t()
        self._steer("a shape needs finite values, min below max, a radius above 0, 3 to 10000 corners",
                    _CORE.sph2d_sim_remove_particles, ctypes.byref(made), ctypes.byref(removed))
        return removed.value

    def _index(self, key, what):
        """The index of a body, obstacle or probe by name or number."""
        items = self._keys[what]
        if isinstance(key, str):
            for k, item in enumerate(items):
                if item["name"] == key:
                    return k
            names = ", ".join(item["name"] for item in items if item["name"]) or "none"
            raise KeyError(f"the scene's {what} have no name {_shown(key)}; names: {names}")
        number = _scalar("which", key, "a name or a number")
        if not 0 <= number < len(items):
            raise IndexError(f"{_shown(key)} is not the number of one of {len(items)} {what}")
        return _whole("which", number, 0, len(items) - 1)

    def body(self, which: Union[str, Number]) -> BodyState:
        """The BodyState of a body, by name or number. Errors: KeyError, IndexError."""
        return _python(self._get(_CORE.sph2d_sim_body, self._index(which, "bodies")))

    def obstacle(self, which: Union[str, Number]) -> BodyState:
        """The BodyState of an obstacle, by name or number. Errors: KeyError, IndexError."""
        return _python(self._get(_CORE.sph2d_sim_obstacle, self._index(which, "obstacles")))

    def set_body_velocity(self, which: Union[str, Number], velocity: Numbers, rate: Number = 0.0) -> None:
        """Sets the velocity [m/s] and angular velocity [rad/s] of a body from the next step on, like a blow. Errors:
        KeyError, IndexError; Error with status INVALID for values that are not finite."""
        self._steer("velocity and rate of a body must be finite", _CORE.sph2d_sim_set_body_velocity,
                    self._index(which, "bodies"), _vec2("velocity", velocity), _number("rate", rate))

    # -- measuring and saving

    def probe(self, which: Union[str, Number]) -> Dict[str, float]:
        """Evaluates a probe of the scene now, by name or number: a dict from its columns, "pressure [Pa]", to values,
        NaN for those that are not defined; impulses are those since the last row of series(). Errors: KeyError, IndexError; Error with status NOMEM."""
        index = self._index(which, "probes")
        return dict(zip(self._columns(index), self._evaluate(index)))

    def series(self, which: Union[str, Number]) -> Dict[str, Floats]:
        """What a probe of the scene measured so far, by name or number, as the file NAME.csv of `sph2d run` has it: a
        dict from "time [s]" and the columns of probe() to arrays, copies. It has a row for each time that the probe's
        `every` or `per_second` asks for, at the end of the step that reaches it, since the simulation was made or
        resumed; impulses of a force probe are those since the row before. Errors: KeyError, IndexError."""
        index = self._index(which, "probes")
        columns = ["time [s]", *self._columns(index)]
        with self._lock:
            rows = np.array(self._rows[index], float).reshape(-1, len(columns))
        return {column: rows[:, k].copy() for k, column in enumerate(columns)}

    def frame(self, which: Union[str, Number]) -> pandas.DataFrame:
        """What series() has, as a DataFrame of pandas. Errors: as of series(); ImportError where pandas is missing."""
        series = self.series(which)
        try:
            import pandas
        except ImportError as error:
            raise ImportError("frame() needs pandas, which is not installed: `pip install pandas`, on Debian `apt "
                              "install python3-pandas`; series() does without") from error
        return pandas.DataFrame(series)

    def _columns(self, index):
        kind = _words("probes.kind").index(self._keys["probes"][index]["kind"])
        return _CORE.sph2d_probe_columns(kind).decode().split(",")

    def _evaluate(self, index):
        values = (ctypes.c_double * 12)()
        count = self._get(_CORE.sph2d_sim_probe, index, values)
        if count == 0:
            raise Error("NOMEM")
        return values[:count]

    def _record(self):
        """Keeps the rows of the probes that are due."""
        for index, rows in enumerate(self._rows):
            if self._get(_CORE.sph2d_sim_output_due, _OUTPUT_PROBE + index):
                rows.append((self.time, *self._evaluate(index)))
                self._get(_CORE.sph2d_sim_output_done, _OUTPUT_PROBE + index)

    def write_snapshot(self, path: Path, compress: Number = 0) -> None:
        """Writes all that is needed to go on, as HDF5 (docs/snapshots.md), whole or not at all. compress: deflate
        level, 0 to 9. Errors: Error with status CANTCREAT, IO, NOMEM; ValueError for another level."""
        report, name = _STRUCT["report"](), _path_bytes("path", path)
        compress = _whole("compress", compress, 0, 9)
        with self._lock, _IO_LOCK:
            status = self._get(_IO.sph2d_snapshot_write, self._scene._file, compress, name, ctypes.byref(report))
        _tell(status, report)


def _members(name, value, *keys):
    """The values of a dict with just these keys."""
    if not isinstance(value, collections.abc.Mapping) or {*value} != {*keys}:
        raise ValueError(f"{name} must be a dict with {' and '.join(keys)}, not {_shown(value)}")
    return [value[key] for key in keys]


def _shape(shape):
    """A shape for C, and its corners, which must live as long."""
    made, corners = _STRUCT["shape"](), None
    words = {"box", "circle", "disc", "polygon"}
    if not isinstance(shape, collections.abc.Mapping) or len(shape) != 1 or not {*shape} < words:
        raise ValueError(f"a shape is a box, circle or polygon as of a drain, not {_shown(shape)}")
    (name, value), = shape.items()
    name = "circle" if name == "disc" else name
    made.kind = _ENUM["SHAPE_" + name.upper()]
    if name == "box":
        low, high = _members("shape.box", value, "min", "max")
        made.box.min, made.box.max = _vec2("shape.box.min", low), _vec2("shape.box.max", high)
    elif name == "circle":
        center, radius = _members("shape.circle", value, "center", "radius")
        made.circle.center = _vec2("shape.circle.center", center)
        made.circle.radius = _number("shape.circle.radius", radius)
    else:
        corners = _numbers("shape.polygon", value, (-1, 2))
        made.points.items, made.points.count = corners.ctypes.data, len(corners)
    return made, corners


def _isa_of(name):
    sets = {"auto": _ENUM["ISA_AUTO"]}
    for isa in ("ISA_BASELINE", "ISA_AVX2", "ISA_AVX512"):
        sets[_CORE.sph2d_isa_name(_ENUM[isa]).decode()] = _ENUM[isa]
    return sets[_choice("isa", name, sets)]


# ---- snapshots -------------------------------------------------------------------------------------------------------


class _SnapshotMemory(_Owner):
    """A snapshot of the library, as long as anything uses it."""

    _no_copy = "the memory of a snapshot cannot be copied: copy() its arrays"

    def __init__(self, address):
        self.address = address
        _own(self, _destroy_snapshot, address)


class Snapshot(_Pictured, _Unchanging):
    """A snapshot that was read into memory, where it does not change, so that copy.copy() gives the snapshot itself; it
    is freed with the last reference to it or to one of its arrays. It cannot be pickled, the name of its file can.

    path: the file. checked: whether its checksum must be right, default True; False reads files that another program
    has changed, which must come from a source that is trusted. Errors: Error with status NOINPUT, FORMAT, NOMEM."""

    _no_copy = "a Snapshot cannot be pickled: pickle the name of its file, and read it again"

    def __init__(self, path: Path, checked: bool = True) -> None:
        report, made, name = _STRUCT["report"](), ctypes.c_void_p(), _path_bytes("path", path)
        read = _IO.sph2d_snapshot_read if _flag("checked", checked) else _IO.sph2d_snapshot_read_unchecked
        with _IO_LOCK:
            status = read(name, ctypes.byref(made), ctypes.byref(report))
        if status == _OK:
            self._memory = _SnapshotMemory(made.value)
        _tell(status, report)

    @property
    def info(self) -> SnapshotInfo:
        """What it says of itself: a SnapshotInfo."""
        with _IO_LOCK:
            info = _python(_IO.sph2d_snapshot_get_info(self._memory.address))
        words = _words("boundary.left")
        return info._replace(boundary=Boundary(*(words[side] for side in info.boundary)))

    def _arrays(self):
        state = _IO.sph2d_snapshot_state(self._memory.address)
        return (_STRUCT["array"] * state.array_count).from_address(state.arrays)

    def names(self, group: str = "fluid") -> List[str]:
        """The names of the arrays of a group: "fluid", "wall", "run" or "outline"."""
        wanted = _group(group)
        with _IO_LOCK:
            return [array.name.decode() for array in self._arrays() if array.group == wanted]

    @overload
    def field(self, name: _Pairs, group: str = "fluid") -> Tuple[Floats, Floats]: ...  # type: ignore[overload-overlap]

    @overload
    def field(self, name: str, group: str = "fluid") -> NDArray[Any]: ...

    def field(self, name: str, group: str = "fluid") -> Any:
        """An array by name, read-only, without a copy; of points a tuple of two. Errors: KeyError, which lists the
        names; ValueError for another group."""
        names = self.names(group)
        if not isinstance(name, str) or name not in names:
            raise KeyError(f"{_shown(name)} is not one of {', '.join(names)}")
        with _IO_LOCK:
            found = _IO.sph2d_snapshot_array(self._memory.address, _group(group), name.encode())
        return _components(_STRUCT["array"].from_address(found), self._view)

    def _view(self, kind, address, count, stride):
        if count == 0:
            return _copy(kind, address, count)
        return np.asarray(_Borrowed(self._memory, kind, address, count, stride))

    def _particles(self, group):
        names, made = self.names(group), {}
        for keys, name in ((("x", "y"), "Coordinates"), (("vx", "vy"), "Velocities"), (("ax", "ay"), "Accelerations"),
                           (("density",), "Densities"), (("pressure",), "Pressures"), (("id",), "ParticleIDs"),
                           (("color",), "Colors")):
            if name in names:
                arrays = self.field(name, group)
                made.update(zip(keys, arrays if len(keys) > 1 else (arrays,)))
        return Particles(**made)

    @property
    def fluid(self) -> Particles:
        """The particles of the liquid."""
        return self._particles("fluid")

    @property
    def walls(self) -> Particles:
        """The boundary particles."""
        return self._particles("wall")

    def scene(self, set: Changes = None) -> Scene:
        """The Scene that it was written with, with changes on top as of Scene. Errors: as of Scene, and Error with
        status FORMAT when it holds none."""
        scene, changes = Scene.__new__(Scene), _overrides(set)
        report, file = _STRUCT["report"](), ctypes.c_void_p()
        with _IO_LOCK:
            status = _IO.sph2d_snapshot_scene(self._memory.address, changes, len(changes), ctypes.byref(file),
                                              ctypes.byref(report))
        scene._take(file.value, status, report)
        return scene

    def resume(self, *, threads: Number = 0, device: Number = 0, same_bits: bool = False,
               contacts: bool = True) -> Simulation:
        """A Simulation that goes on from here, bit for bit, with the instruction set of the snapshot, or on a device with
        "baseline"; arguments as of Simulation. Errors: as of Simulation and scene()."""
        return self._resume(Simulation, (threads, contacts, device, same_bits))

    def _resume(self, kind, given):
        sim = kind.__new__(kind)
        with _IO_LOCK:
            state = _IO.sph2d_snapshot_state(self._memory.address)
        sim._create(self.scene(), state, "auto", given)
        return sim


def _resumed(kind, content, given):
    """A simulation of a class from the bytes of a snapshot, which pickle has kept."""
    with tempfile.TemporaryDirectory() as folder:
        path = pathlib.Path(folder, "state.h5")
        path.write_bytes(content)
        return Snapshot(path)._resume(kind, given)


# ---- pictures --------------------------------------------------------------------------------------------------------


def _within(particles, info):
    """Which particles are not in the reservoirs behind openings: within four spacings of sides that are walls."""
    (left, bottom), (right, top) = info.domain
    beyond, kept = 4 * info.spacing, np.ones(len(particles), bool)
    for side, values, low, high in (("left", particles.x, left, np.inf), ("right", particles.x, -np.inf, right),
                                    ("bottom", particles.y, bottom, np.inf), ("top", particles.y, -np.inf, top)):
        if getattr(info.boundary, side) == "wall":
            kept &= (values >= low - beyond) & (values <= high + beyond)
    return kept


# What pictures need beside particles.
_Space = collections.namedtuple("_Space", "domain boundary spacing name time sound_speed")


def _space_of(source):
    if isinstance(source, Snapshot):
        info = source.info
        return _Space(info.domain, info.boundary, info.spacing, info.scene_name, info.time, info.sound_speed)
    if not isinstance(source, Simulation):
        raise TypeError(f"source must be a Simulation or a Snapshot, not {_shown(source)}")
    keys = source._keys
    return _Space(Box(**keys["domain"]), Boundary(**keys["boundary"]), keys["spacing"], keys["name"], source.time,
                  source.plan.sound_speed)


def _frames_of(source):
    """The values of run.frames, with the ranges that a simulation has set where none were given."""
    if isinstance(source, Snapshot):
        with _IO_LOCK:
            frames = _IO.sph2d_snapshot_get_info(source._memory.address).frames
            return _group_value(_key_at("run.frames").keys, ctypes.addressof(frames))
    return _group_value(_CORE.sph2d_scene_keys(), source._get(_CORE.sph2d_sim_scene))["run"]["frames"]


def _color(name):
    """The number of a colour."""
    rgb = ctypes.c_uint32()
    if not _CORE.sph2d_color_parse(name.encode(), ctypes.byref(rgb)):
        raise ValueError(f"{_shown(name)} is no colour: \"#ff8000\", or a name of CSS")
    return rgb.value


def _rgb(colors):
    """Red, green and blue, 0 to 1."""
    return (colors.astype(np.int64)[:, None] >> np.array([16, 8, 0]) & 255) / 255


def _tint_of(source):
    """The colour of the liquid; None where it has that of the look."""
    rgb = ctypes.c_uint32()
    if isinstance(source, Snapshot):
        with _IO_LOCK:
            fluid = _IO.sph2d_snapshot_get_info(source._memory.address).fluid
            given = _CORE.sph2d_fluid_color(ctypes.byref(fluid), ctypes.byref(rgb))
    else:
        fluid = source._get(_CORE.sph2d_sim_scene) + _key_at("fluid").offset
        given = _CORE.sph2d_fluid_color(fluid, ctypes.byref(rgb))
    return rgb.value if given else None


def _paths_of(source, space):
    """The paths of tracers: x, y, and the number of the line that a place is on, one line after the other."""
    if isinstance(source, Snapshot):
        if "TracerPlaces" not in source.names("run"):
            return None
        places, probes = source.field("TracerPlaces", "run"), source.field("TracerProbes", "run")
    else:
        with source._lock:
            paths = source._get(_CORE.sph2d_sim_paths)
            places, probes = _copy(_F64, paths.places, 2 * paths.count), _copy(_U64, paths.probes, paths.count)
    order = np.argsort(probes, kind="stable")
    places, probes = np.reshape(places, (-1, 2))[order], probes[order]
    ends = np.diff(probes) != 0
    for axis, side in enumerate(("left", "bottom")):
        if getattr(space.boundary, side) == "periodic":
            size = space.domain[1][axis] - space.domain[0][axis]
            ends |= np.abs(np.diff(places[:, axis])) > size / 2
    lines = np.concatenate([[0], np.cumsum(ends)]) if len(places) else []
    return [np.ascontiguousarray(places[:, 0]), np.ascontiguousarray(places[:, 1]), np.asarray(lines, np.uint64)]


def _wall_thickness(space):
    """As in frames of the command."""
    (left, bottom), (right, top) = space.domain
    return max(space.spacing, 0.008 * max(right - left, top - bottom))


def _domain_and_walls(space):
    """The corners of what is shown."""
    (left, bottom), (right, top) = space.domain
    thick = _wall_thickness(space)
    return (left - thick, bottom - thick), (right + thick, top + thick)


def _caption(space):
    """"dam_break   t = 0.250 s", with the decimals that frames have."""
    digits = math.ceil(-math.log10(10 * space.spacing / space.sound_speed)) if space.sound_speed > 0 else 3
    return f"{space.name}   t = {space.time:.{min(max(digits, 0), 9)}f} s"


def _unit_text(unit):
    """The unit of powers of m, kg and s."""
    if tuple(unit) == (-1, 1, -2):
        return "Pa"
    over, under = (" ".join(name + (f"^{sign * power}" if sign * power > 1 else "")
                            for name, power in zip(("kg", "m", "s"), (unit[1], unit[0], unit[2])) if sign * power > 0)
                   for sign in (1, -1))
    return (over or "1") + (f"/({under})" if " " in under else f"/{under}") if under else over


def _is_diverging(name):
    return name == "vorticity"


def _quantity(source, name):
    """A quantity that colours particles, by its name in run.frames.color: a value for each of source.fluid, and its
    label."""
    fields = (_CORE.sph2d_field(None, _ENUM["GROUP_FLUID"], k)
              for k in range(_CORE.sph2d_field_count(_ENUM["GROUP_FLUID"])))
    units = {field.name.decode(): _unit_text(field.unit) for field in fields if field.components == 1}
    _choice("color", name, ("speed", "vorticity", *units))
    if name == "vorticity":
        return vorticity(source), "vorticity [1/s]"
    if name == "speed":
        return np.hypot(source.fluid.vx, source.fluid.vy), "speed [m/s]"
    return source.field(name).astype(float), f"{name} [{units[name]}]" if units[name] else name


def _limits(values, diverging):
    """The values at both ends of the colours, None without one: the 1st and 99th percentile, as in frames."""
    known = np.sort(np.abs(values) if diverging else values)
    known = known[np.isfinite(known)]
    if len(known) == 0:
        return None
    beyond = int(0.01 * (len(known) - 1) + 0.5)
    low, high = known[beyond], known[-1 - beyond]
    if not low < high:  # nearly all are the same
        low, high = known[0], known[-1]
    return [-high, high] if diverging else [low, high]


def _plot(source, color, axes, options):
    space, fluid = _space_of(source), source.fluid
    kept, values, label, limits = _within(fluid, space), None, None, None
    if color is not None:
        values, label = _quantity(source, color)
        values, diverging = values[kept], _is_diverging(color)
        limits = _limits(values, diverging)
        options.setdefault("cmap", "RdBu_r" if diverging else "viridis")
    elif fluid.color is not None:
        options.setdefault("facecolors", _rgb(fluid.color[kept]))
    elif _tint_of(source) is not None:
        options.setdefault("facecolors", _rgb(np.array([_tint_of(source)])))
    if axes is None:
        axes = _plots.new_axes()
    elif not hasattr(axes, "add_collection"):
        raise TypeError(f"axes must be those of Matplotlib, not {_shown(axes)}")
    _plots.add_particles(axes, fluid.x[kept], fluid.y[kept], space.spacing, values, label, limits, options)
    _plots.add_outlines(axes, *source.field("Coordinates", "outline"), source.field("OutlineIDs", "outline"),
                        source.field("LiquidSides", "outline"))
    low, high = _domain_and_walls(space)
    axes.set(aspect="equal", xlim=(low[0], high[0]), ylim=(low[1], high[1]), xlabel="x [m]", ylabel="y [m]",
             title=_caption(space))
    return axes


def _frame_png(source):
    """The picture of a frame as PNG. It follows nothing."""
    space, frames, given = _space_of(source), _frames_of(source), {}
    if frames["color"]:
        values, label = _quantity(source, frames["color"])
        shown = _within(source.fluid, space)
        given.update(values=values, label=label, diverging=_is_diverging(frames["color"]))
        given["value_range"] = frames["color_range"] if any(frames["color_range"]) else (
            _limits(values[shown], given["diverging"]) or (0, 0))
    if frames["isolines"]:
        given["levels"], given["level_label"] = _quantity(source, frames["isolines"])
        given["level_step"] = frames["isoline_step"]
    low, high = frames["view"]["min"], frames["view"]["max"]
    if low < high:
        given["view"] = low, high
    if frames["radius"]:
        given["radius"] = frames["radius"]
    if frames["caption"] == "on":
        given["caption"] = _caption(space)
    with Renderer(*frames["size"], frames["style"], frames["look"], frames["background"]) as renderer, \
            tempfile.TemporaryDirectory() as folder:
        renderer.draw(source, arrows=frames["arrows"] == "on", streamlines=frames["streamlines"] == "on",
                      streamline_spacing=frames["streamline_spacing"], arrow_spacing=frames["arrow_spacing"],
                      arrow_speed=frames["arrow_speed"], **given)
        path = pathlib.Path(folder, "frame.png")
        renderer.write_png(path)
        return path.read_bytes()


def vorticity(source: Union[Simulation, Snapshot]) -> Floats:
    """The vorticity dv_y/dx - dv_x/dy at each of source.fluid [1/s], of a Simulation or Snapshot: an array of its own.
    It is exact for linear velocities, also at surfaces; NaN at particles that are alone. Errors: Error with status
    NOMEM."""
    space, fluid, report = _space_of(source), source.fluid, _STRUCT["report"]()
    arrays = [np.ascontiguousarray(numbers, float) for numbers in (fluid.x, fluid.y, fluid.vx, fluid.vy)]
    out = np.empty(len(fluid))
    _tell(_CORE.sph2d_vorticity(len(out), *(array.ctypes.data for array in arrays), space.spacing,
                                out.ctypes.data, ctypes.byref(report)), report)
    return out


def devices() -> List[Device]:
    """The devices with OpenCL 1.2 that can take the steps of a Simulation in place of the processor, in the order of their
    numbers; empty where there are none, or no OpenCL."""
    room = (_STRUCT["device"] * _CORE.sph2d_devices(None, 0))()
    count = _CORE.sph2d_devices(ctypes.addressof(room), len(room))
    return [_python(made) for made in room[:count]]


def _word_index(name, word):
    """The number of a word of the key run.frames.NAME."""
    words = _words(f"run.frames.{name}")
    return words.index(_choice(name, word, words))


class Renderer(_Owner):
    """Draws pictures without a window (libsph2d-render); used by one thread at a time.

    width, height: size [pixels], 16 to 16384, default 1280 x 720. style: "metaballs", a liquid surface, the default, or
    "points". look: shading of metaballs, "water", the default, "flat", "glass" or "ink". background: "opaque", the
    default, or "transparent". gl: kind of OpenGL context, "osmesa" or "egl"; default None: the first that works.
    close() frees it; it is a context manager, too; it cannot be copied or pickled. Errors: Error with status RENDER,
    also where the library is missing, and NOMEM; ValueError for another size, style, look or background."""

    _no_copy = "a Renderer cannot be copied or pickled: make another one of the same size and style"

    def __init__(self, width: Number = 1280, height: Number = 720, style: str = "metaballs", look: str = "water",
                 background: str = "opaque", gl: Optional[str] = None) -> None:
        library = _load_optional("sph2d-render", "RENDER", "for pictures")
        options = library.sph2d_render_options_default()
        if options.struct_size != ctypes.sizeof(options):
            raise _failure("RENDER", "libsph2d-render has structs other than those of the Python module: install both "
                           "from the same source")
        options.width, options.height = _whole("width", width, 16, 16384), _whole("height", height, 16, 16384)
        options.style, options.look = _word_index("style", style), _word_index("look", look)
        options.background = _word_index("background", background)
        options.gl = _text("gl", gl)
        made, report = ctypes.c_void_p(), _STRUCT["report"]()
        status = library.sph2d_renderer_create(ctypes.byref(options), ctypes.byref(made), ctypes.byref(report))
        self._library, self._lock, self._renderer = library, threading.RLock(), made.value
        self._shape = options.height, options.width, 4
        if status == _OK:
            self._destroy = _own(self, library.sph2d_renderer_destroy, self._renderer)
        self._default_radius = 0.5 if options.style == _ENUM["STYLE_POINTS"] else 2
        _tell(status, report)

    def close(self) -> None:
        """Frees it. Twice is fine."""
        with self._lock:
            if self._renderer:
                self._renderer = None
                self._destroy()

    def __enter__(self) -> Renderer:
        return self

    def __exit__(self, *_: object) -> None:
        self.close()

    def _call(self, function, *arguments):
        if not self._renderer:
            raise ValueError("the renderer is closed")
        report = _STRUCT["report"]()
        _tell(function(self._renderer, *arguments, ctypes.byref(report)), report)

    def draw(self, source: Union[Simulation, Snapshot], values: Optional[Numbers] = None, label: Optional[str] = None,
             value_range: Numbers = (0, 0), view: Optional[Numbers] = None, radius: Optional[Number] = None,
             caption: Optional[str] = None, notes: Optional[str] = None, arrows: bool = False,
             levels: Optional[Numbers] = None, level_label: Optional[str] = None, level_step: Number = 0,
             diverging: bool = False, streamlines: bool = False, streamline_spacing: Number = 0,
             arrow_spacing: Number = 0, arrow_speed: Number = 0) -> NDArray[np.uint8]:
        """Draws a Simulation or Snapshot and returns the picture: an array (height, width, 4) of bytes, red, green,
        blue, alpha (255 but for a transparent background), top row first.

        values: numbers to colour by, one for each of source.fluid, NaN is grey; default None: its colours. label:
        text at their colour bar; default None. value_range: values at its ends; default (0, 0): the smallest and
        largest. view: corners ((left, bottom), (right, top)) of what is shown [m]; default None: the domain and its
        walls. radius: of a metaball or point [m]; default None: 2 spacings, half a spacing for points. caption: a
        line of text below the picture, beside a scale bar; default None: no strip. notes: lines of it in a
        box; default None. arrows: whether arrows show the velocity, one in each square of arrow_spacing [m], default
        0: a 32nd of the view, as long as two squares at arrow_speed [m/s], default 0: the largest; default False.
        levels: numbers to draw isolines of, one for each of source.fluid, at multiples of level_step, default 0: a
        round number; level_label: what the strip calls them. diverging: colours for values of either sign, as those of
        vorticity(), and a range symmetric about 0; default False. streamlines: whether evenly spaced lines along the
        velocity are drawn, streamline_spacing apart [m], default 0: a 40th of a square view.
        Errors: Error with status INVALID, RENDER, NOMEM; ValueError for values or levels of another shape."""
        space, fluid = _space_of(source), source.fluid
        kept = _within(fluid, space)
        arrays = {"x": fluid.x[kept], "y": fluid.y[kept]}
        arrays["outline_x"], arrays["outline_y"] = source.field("Coordinates", "outline")
        arrays["outline_id"] = source.field("OutlineIDs", "outline")
        arrays["outline_liquid"] = source.field("LiquidSides", "outline")
        for name, numbers in (("values", values), ("level_values", levels)):
            if numbers is not None:
                arrays[name] = _numbers("levels" if name == "level_values" else name, numbers, (len(fluid),))[kept]
        if _flag("arrows", arrows):
            arrays["vx"], arrays["vy"] = fluid.vx[kept], fluid.vy[kept]
        if _flag("streamlines", streamlines):
            arrays["stream_vx"], arrays["stream_vy"] = fluid.vx[kept], fluid.vy[kept]
        paths, tint = _paths_of(source, space), _tint_of(source)
        if paths is not None:
            arrays["path_x"], arrays["path_y"], arrays["path_id"] = paths
        if fluid.color is not None:
            arrays["colors"] = fluid.color[kept]
        picture = _STRUCT["picture"](**{name: array.ctypes.data for name, array in arrays.items()})
        picture.count, picture.outline_count = len(arrays["x"]), len(arrays["outline_x"])
        picture.path_count = 0 if paths is None else len(paths[0])
        picture.tinted, picture.tint = tint is not None, tint or 0
        whole = _domain_and_walls(space)
        picture.inside.min, picture.inside.max = _vec2("inside", whole[0]), _vec2("inside", whole[1])
        low, high = _numbers("view", whole if view is None else view, (2, 2))
        picture.view.min, picture.view.max = _vec2("view", low), _vec2("view", high)
        picture.radius = self._default_radius * space.spacing if radius is None else _number("radius", radius)
        picture.wall_thickness, picture.spacing = _wall_thickness(space), space.spacing
        picture.value_min, picture.value_max = _numbers("value_range", value_range, (2,))
        picture.level_step = _number("level_step", level_step)
        picture.streamline_spacing = _number("streamline_spacing", streamline_spacing)
        picture.arrow_spacing = _number("arrow_spacing", arrow_spacing)
        picture.arrow_speed = _number("arrow_speed", arrow_speed)
        picture.diverging = _flag("diverging", diverging)
        picture.value_label, picture.level_label = _text("label", label), _text("level_label", level_label)
        picture.caption, picture.notes = _text("caption", caption), _text("notes", notes)
        with self._lock:
            self._call(self._library.sph2d_renderer_draw, ctypes.byref(picture))
            pixels = self._library.sph2d_renderer_pixels(self._renderer)
            return np.frombuffer(ctypes.string_at(pixels, math.prod(self._shape)), np.uint8).reshape(self._shape)

    def write_png(self, path: Path) -> None:
        """Writes the last picture as a PNG, RGB or with a transparent background RGBA, whole or not at all. Errors:
        Error with status INVALID (nothing drawn), CANTCREAT, IO, NOMEM."""
        name = _path_bytes("path", path)
        with self._lock:
            self._call(self._library.sph2d_renderer_write_png, name)
