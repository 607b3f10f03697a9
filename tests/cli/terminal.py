# SPDX-License-Identifier: MIT
"""Types into an interactive shell on a pseudo terminal, and returns the lines that completion makes of them."""
import os
import pty
import select
import signal
import time

LIMIT = 30 * int(os.environ.get("CK_TIMEOUT_MULTIPLIER", 1))
LATE = f"within its limit of {LIMIT} s by the clock (CK_TIMEOUT_MULTIPLIER=5 gives five times as much)"


class Shell:
    """A shell that starts with no settings but `setup`. Ctrl-X e puts what is on its line into a file."""

    BASH = r"""
bind 'set bell-style none'
bind 'set enable-bracketed-paste off'
bind 'set completion-query-items 0'
__line() { printf '%s\n' "$READLINE_LINE" >"$LINE_FILE.new" && mv "$LINE_FILE.new" "$LINE_FILE"; READLINE_LINE=''; }
bind -x '"\C-xe": __line'
bind '"\C-xa": insert-completions'
PS1='ready> '
"""
    ZSH = r"""
unsetopt beep prompt_cr prompt_sp
__line() { print -r -- "$BUFFER" >"$LINE_FILE.new" && mv "$LINE_FILE.new" "$LINE_FILE"; BUFFER='' }
zle -N __line
bindkey -e
bindkey '^Xe' __line
zle -C all-matches complete-word _generic
bindkey '^Xa' all-matches
zstyle ':completion:all-matches:*' insert true
zstyle ':completion:all-matches::::' completer _all_matches _complete
PS1='ready> '
"""

    def __init__(self, kind, folder, setup, environment=None):
        self.line_file = os.path.join(folder, "line." + kind)
        start = {"bash": ["bash", "--norc", "--noprofile", "-i"], "zsh": ["zsh", "-f", "-i"]}[kind]
        variables = {**os.environ, "TERM": "vt100", "LINE_FILE": self.line_file, **(environment or {})}
        settings = os.path.join(folder, "setup." + kind)
        with open(settings, "w", encoding="utf-8") as file:
            file.write(setup + (self.BASH if kind == "bash" else self.ZSH))
        self.pid, self.terminal = pty.fork()
        if self.pid == 0:
            os.execvpe(start[0], start, variables)
        self.type(f" . {settings}\r")
        self.seen("ready> ")

    def type(self, keys):
        os.write(self.terminal, keys.encode())

    def seen(self, text):
        """Waits until the shell has printed a text."""
        output, end = "", time.monotonic() + LIMIT
        while text not in output:
            if not select.select([self.terminal], [], [], max(0, end - time.monotonic()))[0]:
                raise AssertionError(f"no '{text}' {LATE} in:\n{output}")
            output += os.read(self.terminal, 65536).decode(errors="replace")

    def complete(self, keys):
        """The line after these keys; \t completes, Ctrl-X a inserts all that fits."""
        if os.path.exists(self.line_file):
            os.remove(self.line_file)
        self.type(keys + "\x18e")
        end = time.monotonic() + LIMIT
        while not os.path.exists(self.line_file):
            if time.monotonic() > end:
                raise AssertionError(f"no answer to {keys!r} {LATE}")
            while select.select([self.terminal], [], [], 0.01)[0]:
                os.read(self.terminal, 65536)
        with open(self.line_file, encoding="utf-8") as file:
            return file.read()[:-1]

    def everything(self, keys):
        """All words that completion offers for the word at the end of these keys."""
        before = keys[: keys.rindex(" ") + 1]
        line = self.complete(keys + "\x18a")
        assert line.startswith(before), line
        return set(line[len(before) :].split())

    def close(self):
        os.kill(self.pid, signal.SIGKILL)
        os.waitpid(self.pid, 0)
        os.close(self.terminal)
