# SPDX-License-Identifier: MIT
"""Completes a line in bash and in zsh as they are after an installation: nothing but what the packages put there."""
from terminal import Shell

SETTINGS = {
    "bash": ". /usr/share/bash-completion/bash_completion\n",
    "zsh": "autoload -Uz compinit && compinit -D -u\n",
}
for kind, setup in SETTINGS.items():
    shell = Shell(kind, ".", setup)
    for keys, rest in ("sph2d run sce", "ne.yaml "), ("sph2d run --isa base", "line "):
        line = shell.complete(keys + "\t")
        assert line == keys + rest, (kind, line)
    shell.close()
