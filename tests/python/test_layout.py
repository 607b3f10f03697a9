"""What the module declares of C is what the headers declare: the compiler says so."""
import ctypes
import re
import subprocess
import unittest

import common
from common import sph2d

NAMES = re.compile(r"\bsph2d_\w+")


def functions_text():
    return "".join(sph2d._FUNCTIONS_TEXT.values())


def structs_of(text):
    return re.findall(r"typedef struct (\w+) \{(.*?)\} \1;", text, re.DOTALL)


def members_of(body):
    """(name, C type, length) of each member, the last "" for none."""
    for member in filter(str.strip, body.split(";")):
        base, declarators = re.fullmatch(sph2d._BASE + "(.*)", " ".join(member.split())).groups()
        for declarator in declarators.split(", "):
            stars, name, length = re.fullmatch(sph2d._DECLARATOR, declarator).groups()
            yield name, f"{base} {stars}", length


def program(types, functions):
    """A C program that does not compile where names or types differ, and prints sizes and offsets of structs."""
    lines = ["#include <stddef.h>", "#include <stdio.h>"]
    lines += [f"#include <sph2d/{name}.h>" for name in ("sph2d", "io", "contacts", "render")]
    lines += [functions, f'_Static_assert(SPH2D_OUTPUT_PROBE == {sph2d._OUTPUT_PROBE}, "");']
    lines += [f'_Static_assert(sizeof(SPH2D_VERSION) == {len(sph2d.__version__) + 1}, "");']
    for name, body in re.findall(r"typedef enum (\w+) \{(.*?)\} \1;", types, re.DOTALL):
        lines.append(f'_Static_assert(sizeof({name}) == sizeof(int), "{name}");')
        lines += [f'_Static_assert({constant}, "");' for constant in body.replace("=", "==").split(",")]
    lines += ["int main(void) {", "puts(SPH2D_VERSION);"]
    for struct, body in structs_of(types):
        lines.append(f'printf("{struct} %zu\\n", sizeof({struct}));')
        for name, kind, length in members_of(body):
            lines.append(f'printf("{struct}.{name} %zu\\n", offsetof({struct}, {name}));')
            if kind != "void *":  # pointers to functions
                kind = f"__typeof__({kind} [{length}])" if length else f"__typeof__({kind})"
                member = f"__typeof__((({struct} *)0)->{name})"
                lines.append(f'_Static_assert(__builtin_types_compatible_p({member}, {kind}), "{struct}.{name}");')
    return "\n".join([*lines, "return 0;", "}", ""])


def layout():
    """The same sizes and offsets by ctypes."""
    lines = [sph2d.__version__]
    for name, _ in structs_of(sph2d._TYPES_TEXT):
        struct = sph2d._TYPES[name]
        lines.append(f"{name} {ctypes.sizeof(struct)}")
        lines += [f"{name}.{member} {getattr(struct, member).offset}" for member, _ in struct._fields_]
    return lines


class Layout(common.InFolder):
    def compiled(self, types, functions):
        """The lines that the program prints; None when it does not compile."""
        with open("layout.c", "w") as file:
            file.write(program(types, functions))
        command = [*common.COMPILER, "-std=gnu17", f"-I{common.ROOT}/include", "layout.c", "-o", "layout"]
        self.built = subprocess.run(command, capture_output=True, text=True)
        if self.built.returncode:
            return None
        return subprocess.run(["./layout"], capture_output=True, text=True, check=True).stdout.splitlines()

    def test_the_headers_say_the_same(self):
        lines = self.compiled(sph2d._TYPES_TEXT, functions_text())
        self.assertIsNotNone(lines, self.built.stderr)
        self.assertEqual(lines, layout())

    def test_differences_are_found(self):
        types, functions = sph2d._TYPES_TEXT, functions_text()
        for old, new in (("double energy_rise; ", "float energy_rise; "),
                         ("SPH2D_KEY_LIST = 11", "SPH2D_KEY_LIST = 12"), ("char hint[480]", "char hint[481]"),
                         ("bool required", "int required")):
            self.assertIn(old, types)
            self.assertIsNone(self.compiled(types.replace(old, new), functions), old)
        for old, new in (("double radius, double", "float radius, double"),
                         ("uint64_t sph2d_sim_steps", "int sph2d_sim_steps")):
            self.assertIn(old, functions)
            self.assertIsNone(self.compiled(types, functions.replace(old, new)), old)
        self.assertNotEqual(self.compiled(types.replace("double fed, blocked; ", "").replace("uint64_t drained; ", ""),
                                          functions), layout())

    def test_what_is_declared_is_used(self):
        with open(sph2d.__file__) as file:
            code = file.read()
        used = set(re.findall(r"(?:_CORE|_IO|library|_library)\.(sph2d_\w+)", code.replace(functions_text(), "")))
        declared = set(re.findall(r"(sph2d_\w+)\(", functions_text()))
        self.assertEqual(used, declared)
        structs = {name for name, _ in structs_of(sph2d._TYPES_TEXT)}
        needed = set(re.findall(r'_STRUCT\["(\w+)"\]', code))
        texts = sph2d._TYPES_TEXT + functions_text()
        for name in structs:
            inside = len(re.findall(rf"\b{name}\b", texts)) > 2
            self.assertTrue(inside or name[len("sph2d_"):] in needed, name)

    def test_rows_are_five_numbers(self):
        self.assertEqual(ctypes.sizeof(sph2d._STRUCT["sample"]), 40)  # as sample() takes it
        self.assertEqual(ctypes.sizeof(sph2d._STRUCT["particle"]), 48)  # as add_particles() gives it


if __name__ == "__main__":
    unittest.main()
