# SPDX-License-Identifier: MIT
"""What calls hand out: named tuples, those of structs of C with the fields of these, which tests/python/test_layout.py
compares."""
from __future__ import annotations

from typing import TYPE_CHECKING, NamedTuple, Optional, Tuple

if TYPE_CHECKING:
    import numpy as np
    from numpy.typing import NDArray

Point = Tuple[float, float]


class Diagnostic(NamedTuple):
    """One sentence of a report.

    severity: "error" or "warning"; code: "S104", as `sph2d help codes` lists them; path: key of the scene,
    "blocks[0].box.max", "" for none; file, line, column, excerpt: where it was written, counted from 1, "" and 0 if
    unknown; message: what is wrong; hint: what to do about it; text: all of it as the command prints it."""

    severity: str
    code: str
    path: str
    file: str
    line: int
    column: int
    excerpt: str
    message: str
    hint: str
    text: str


class Summary(NamedTuple):
    """Totals and errors of a run: the fields of sph2d_summary, documented in sph2d/sim.h.

    What `sph2d run --json` prints has the same names, but energy_kinetic, energy_potential, energy_elastic and
    energy_bodies for kinetic, potential, elastic and bodies, and objects and pairs for the tuples."""

    time: float
    steps: int
    particle_steps: int
    particles: int
    compression_p99: float
    compression_mean: float
    compression_max: float
    kinetic: float
    potential: float
    elastic: float
    energy_start: float
    energy_rise: float
    energy_error: float
    energy_error_rise: float
    energy_walls: float
    energy_forces: float
    energy_viscous: float
    energy_diffused: float
    energy_stopped: float
    bodies: float
    energy_contacts: float
    energy_pressed: float
    energy_scale: float
    kinetic_max: float
    density_apart: float
    energy_fed: float
    momentum: Point
    momentum_error: Point
    momentum_error_max: float
    momentum_moved: float
    speed_max: float
    paired: int
    fed: int
    blocked: int
    drained: int
    let_in: int
    let_out: int
    left_open: Tuple[int, int, int, int]
    backstop_hits: int
    reflections: int
    iterations: int
    unconverged: int
    limited_by: Tuple[int, int, int, int]
    time_step_min: float
    time_step_max: float
    neighbours: float


class Plan(NamedTuple):
    """Size and derived parameters of a scene: the fields of sph2d_plan, documented in sph2d/scene.h."""

    fluid_particles: int
    wall_particles: int
    places_left_free: int
    area_asked: float
    area_left_out: float
    most_left_out: float
    most_left_out_block: int
    area_placed: float
    particle_mass: float
    support_radius: float
    sound_speed: float
    sound_speed_formula: str
    head: float
    capillary_head: float
    impact_compression: float
    time_step: float
    time_step_limit: str
    steps: float
    memory: float
    snapshots: float
    frames: float
    disk: float
    disk_of_particle: float


class BodyState(NamedTuple):
    """Where a body or obstacle is, and how it moves.

    center [m], of mass, of an obstacle the point about which it turns; angle since the start [rad], velocity of the
    center [m/s], rate [rad/s], anticlockwise; force of the liquid [N/m] and its torque [N], in the mean over the last
    step, 0 for obstacles. Documented in sph2d/sim.h."""

    center: Point
    angle: float
    velocity: Point
    rate: float
    force: Point
    torque: float


class Box(NamedTuple):
    """A rectangle: its lower left and its upper right corner [m]."""

    min: Point
    max: Point


class Boundary(NamedTuple):
    """The kinds of the sides of a domain, as words: "wall", "open"."""

    left: str
    right: str
    bottom: str
    top: str


class Device(NamedTuple):
    """What can take the steps in place of the processor: the fields of sph2d_device, documented in sph2d/device.h.

    gpu: whether it is a graphics card; same_bits: whether it makes the bits of the processor's "baseline"; lacks: what a
    run needs and it does not have, "" for nothing; memory: in all, and largest: of one block, which holds a run [bytes]."""

    name: str
    platform: str
    driver: str
    gpu: bool
    same_bits: bool
    lacks: str
    units: int
    memory: float
    largest: float


class Densities(NamedTuple):
    """Mean density inside the liquid over rest density, and how much room the liquid takes.

    reported: by the particles; counted: from their number, both NaN if fewer than 20 particles are inside; covered: the
    area that the liquid covers over that of its particles at rest density, NaN without particles."""

    reported: float
    counted: float
    covered: float


class SnapshotInfo(NamedTuple):
    """What a snapshot says of itself: the fields of sph2d_snapshot_info but `fluid` and `frames`, documented in sph2d/io.h. The
    sides of `boundary` are words."""

    scene_name: str
    code_version: str
    method: str
    isa: str
    scene_text: Optional[str]
    time: float
    time_step: float
    steps: int
    domain: Box
    boundary: Boundary
    spacing: float
    support_radius: float
    sound_speed: float


class Sample(NamedTuple):
    """The liquid at points.

    velocity [m/s], shape (..., 2); pressure [Pa], density [kg/m^3] and the number of particles within the support
    radius, shape (...). NaN where no particle is within it."""

    velocity: NDArray[np.float64]
    pressure: NDArray[np.float64]
    density: NDArray[np.float64]
    neighbours: NDArray[np.float64]
