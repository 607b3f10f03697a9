#!/usr/bin/env python3
"""Write docs/gallery.md: run its scenes and take a picture of each: python3 examples/gallery.py build/sph2d [NAME...]

With names only those are run; the others keep their pictures and rows. `make gallery` runs all, 10 to 20 minutes of CPU
time. Needs no package.
"""
import json
import os
import re
import shutil
import subprocess
import sys
import tempfile

HERE = os.path.dirname(os.path.abspath(__file__))
DOCS = os.path.join(HERE, "..", "docs")
PAGE = os.path.join(DOCS, "gallery.md")

# name: (the scene, a file or its folder; time of the picture [s]; changes, of `run.frames` or spacing; a sentence)
SCENES = {
    "post": ("examples/post", 0.6, ["size=[800, 320]"],
             "A column of water falls over a post, and its jet hits a round bar."),
    "breaking wave": ("examples/beach", 9.3, ["style=metaballs", "color_range=[0, 0.6]", "size=[800, 160]"],
                      "A wave from a wave maker runs up a beach and breaks."),
    "fountain": ("examples/fountain", 1.2, ["look=glass", "size=[800, 480]"], "A jet rises from a basin."),
    "drop": ("cli/play/scenes/3_drop.yaml", 0.3, ["spacing=0.006", "every=0.3", "size=[800, 450]"],
             "A drop falls into a basin."),
    "sprinkler": ("examples/sprinkler", 1.6, ["size=[800, 450]"], "A jet over round bars."),
    "water wheel": ("examples/water_wheel", 4, ["style=metaballs", "size=[800, 436]"],
                    "A jet turns a wheel against a brake."),
    "ship": ("examples/ship", 5.5, ["style=metaballs", "color_range=[0, 1]", "size=[800, 267]"],
             "A ship on a mooring, in waves that a piston makes."),
    "honey": ("examples/honey", 0.5, ["look=flat", "size=[800, 400]"],
              "Honey that is poured faster than it can spread folds to and fro."),
    "mixing": ("examples/mixing", 1.2, ["size=[800, 450]"],
               "Columns of coloured water mix, and a particle draws its path."),
    "vortex street": ("examples/cylinder", 8, ["every=8", "color=vorticity", "color_range=[-60, 60]", "size=[800, 220]"],
                      "Vortices leave a cylinder in a stream by turns, Re 100."),
    "splash": ("examples/falling_circle", 0.16, ["style=metaballs", "color_range=[0, 1]", "size=[800, 450]"],
               "A light cylinder falls into water."),
    "mixer": ("examples/mixer", 5, ["style=metaballs", "size=[640, 540]"], "A blade stirs a round tank."),
    "crowd": ("examples/crowd", 0.6, ["look=ink", "size=[800, 450]"],
              "A column of water falls on a heap of 100 discs and boxes."),
}


def run(command, name):
    """Runs the scene and keeps its last frame; returns its row."""
    path, until, changes, sentence = SCENES[name]
    path += "" if path.endswith(".yaml") else "/scene.yaml"
    settings = [change if change.startswith("spacing") else f"run.frames.{change}" for change in changes]
    with tempfile.TemporaryDirectory() as out:
        arguments = [command, "run", os.path.join(HERE, "..", path), "--json", "-o", out, "-f"]
        for setting in [f"run.until={until}", *settings]:
            arguments += ["--set", setting]
        done = subprocess.run(arguments, capture_output=True, text=True, check=False)
        if done.returncode != 0:
            sys.exit(f"{name}: {done.stderr}")
        result = json.loads(done.stdout.splitlines()[-1])
        picture = name.replace(" ", "_") + ".png"
        frames = sorted(os.listdir(os.path.join(out, "frames")))
        shutil.copy(os.path.join(out, "frames", frames[-1]), os.path.join(DOCS, "gallery", picture))
    error, speed = result["error"], result["speed"]
    shown = "".join(f", `{setting}`" for setting in settings if "look" in setting or "spacing" in setting)
    return (f"| ![{sentence}](gallery/{picture}) | **{name}**<br>{sentence}<br>[scene](../{path}){shown}<br>"
            f"{result['particles']['now']:,} particles at t = {until:g} s, {result['steps']:,} steps, "
            f"{speed['step_cpu_seconds']:.0f} s of CPU time<br>"
            f"energy unaccounted for {100 * error['energy_error'] / error['energy_scale']:.2g} %, "
            f"compression {100 * error['compression_p99']:.2g} % |")


HEAD = """# Gallery

Thirteen scenes of this repository, with what each cost and how far it is off: the energy that is unaccounted for, of the
scene's energy, and the compression that 99 % of the particles stay below. `make gallery` runs them and writes this page;
CPU times are those of the machine that did.

| | |
|---|---|
"""


def main():
    """Renews the rows of the page."""
    command, names = os.path.abspath(sys.argv[1]), sys.argv[2:] or list(SCENES)
    os.makedirs(os.path.join(DOCS, "gallery"), exist_ok=True)
    rows = {}
    if os.path.exists(PAGE):
        with open(PAGE, encoding="utf-8") as page:
            found = re.finditer(r"^\| !.*?\*\*(.*?)\*\*.*$", page.read(), re.M)
            rows = {match.group(1): match.group(0) for match in found}
    for name in names:
        rows[name] = run(command, name)
        print(f"{name}: done", flush=True)
        text = HEAD + "".join(rows[key] + "\n" for key in SCENES if key in rows)
        with open(PAGE + ".part", "w", encoding="utf-8") as page:
            page.write(text)
        os.replace(PAGE + ".part", PAGE)


main()
