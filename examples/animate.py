#!/usr/bin/env python3
"""Make one moving picture of the frames of a run: python3 examples/animate.py out/frames film.gif

Needs Pillow. All frames share one palette, so that nothing flickers, and the last one stays for a second.
"""
import glob
import sys

from PIL import Image

COLORS, FRAME_MS, LAST_MS = 96, 30, 1000

frames = [Image.open(path).convert("RGB") for path in sorted(glob.glob(sys.argv[1] + "/frame_*.png"))]
some = frames[:: max(1, len(frames) // 8)]
strip = Image.new("RGB", (frames[0].width, frames[0].height * len(some)))
for row, frame in enumerate(some):
    strip.paste(frame, (0, row * frame.height))
palette = strip.quantize(COLORS, method=Image.Quantize.FASTOCTREE, dither=Image.Dither.NONE)
flat = [frame.quantize(palette=palette, dither=Image.Dither.NONE) for frame in frames]
times = [FRAME_MS] * (len(flat) - 1) + [LAST_MS]
flat[0].save(sys.argv[2], save_all=True, append_images=flat[1:], duration=times, loop=0, optimize=True)
