"""The JSON schemas of scene and study files against the reader, and the files of this tree."""
import copy
import glob
import json
import os
import re
import subprocess
import unittest
import warnings

import common
from common import sph2d

try:
    import jsonschema
    import yaml
except ImportError as error:
    raise unittest.SkipTest(f"{error} (apt install python3-jsonschema python3-yaml)") from None

ROOT = str(common.ROOT)
# Codes of messages about single keys.
KEYS = {"S101", "S103", "S104", "S105", "S106"}
WHOLE = {"domain": {"min": [0, 0], "max": [2, 1]}, "spacing": 0.02}


class Loader(yaml.SafeLoader):
    """YAML 1.2, as editors and the command read it: `on` and `2e-2` are a text and a number."""


Loader.yaml_implicit_resolvers = {}
for tag, pattern, first in [
        ("null", r"~|null|Null|NULL|", [*"~nN", ""]), ("bool", "true|True|TRUE|false|False|FALSE", "tTfF"),
        ("int", "[-+]?[0-9]+", "-+0123456789"),
        ("float", r"[-+]?(\.[0-9]+|[0-9]+(\.[0-9]*)?)([eE][-+]?[0-9]+)?", "-+.0123456789")]:
    Loader.add_implicit_resolver(f"tag:yaml.org,2002:{tag}", re.compile(f"^(?:{pattern})$"), first)
Loader.add_constructor("tag:yaml.org,2002:float", lambda loader, node: float(node.value))
Loader.add_constructor("tag:yaml.org,2002:int", lambda loader, node: int(node.value))


def schema_of(topic):
    schema = json.loads(subprocess.run([common.LIBRARIES / "sph2d", "help", topic], check=True, capture_output=True).stdout)
    jsonschema.Draft7Validator.check_schema(schema)
    assert schema["$schema"] == "http://json-schema.org/draft-07/schema#"
    return jsonschema.Draft7Validator(schema)


def read(name):
    with open(name, encoding="utf-8") as file:
        return yaml.load(file, Loader)


def faults(validator, value):
    return [f"{'.'.join(map(str, e.absolute_path))}: {e.message[:200]}" for e in validator.iter_errors(value)]


def keys_of(schema, path=()):
    """Each key: its path, 0 in lists, and its schema."""
    for name, inner in schema.get("properties", {}).items():
        yield (*path, name), inner
        group = next((part for part in inner.get("anyOf", []) if "properties" in part), inner)
        yield from keys_of(group, (*path, name))
        yield from keys_of(group.get("items", {}), (*path, name, 0))


def places(value, path=()):
    """The path of each key that a scene has."""
    if isinstance(value, dict):
        for name, inner in value.items():
            yield (*path, name)
            yield from places(inner, (*path, name))
    elif isinstance(value, list):
        for index, item in enumerate(value):
            yield from places(item, (*path, index))


def with_change(scene, path, change):
    """A copy of a scene in which `change` was applied to the owner of the last name of a path."""
    scene = copy.deepcopy(scene)
    owner = scene
    for name in path[:-1]:
        owner = owner[name]
    change(owner, path[-1])
    return scene


def renamed(owner, name):
    owner[f"{name}x"] = owner.pop(name)


def replaced(by):
    return lambda owner, name: owner.__setitem__(name, by)


def ends(schema):
    """The ends of the range of a key, and values beyond them."""
    schema = schema.get("items", {}).get("items", schema.get("items", schema))
    for part in schema.get("anyOf", [schema]):
        for name, sign in [("minimum", -1), ("maximum", 1)]:
            if name in part and part[name] < 1e18:
                yield part[name], part[name] + sign * max(1, abs(part[name]))


def nested(value, like):
    """The value as one number of a list, where a key has a list."""
    if isinstance(like, list):
        return [nested(value, like[0]), *like[1:]]
    return value


def faulty_scenes():
    """Scenes with one fault each, the folder of their files, and what it is; each key once."""
    done = set()
    schemas = dict(keys_of(SCENE.schema))
    for name in sorted(glob.glob(f"{ROOT}/tests/restarts/scenes/*.yaml") + glob.glob(f"{ROOT}/examples/*/scene.yaml")):
        scene, folder = read(name), os.path.dirname(name)
        for path in places(scene):
            key = tuple(0 if isinstance(name, int) else name for name in path)
            if key in done or key not in schemas:
                continue
            done.add(key)
            like = scene
            for name in path:
                like = like[name]
            yield folder, with_change(scene, path, renamed), (*path, "no key")
            yield folder, with_change(scene, path, replaced(None)), (*path, "nothing")
            yield folder, with_change(scene, path, replaced([[]] if isinstance(like, (str, dict)) else {"x": 1})), (*path, "type")
            if "enum" in schemas[key]:
                yield folder, with_change(scene, path, replaced("xyzzy")), (*path, "word")
            for end, beyond in ends(schemas[key]):
                yield folder, with_change(scene, path, replaced(nested(end, like))), (*path, "end")
                yield folder, with_change(scene, path, replaced(nested(beyond, like))), (*path, beyond)
            if path[-1] in ("domain", "spacing", "min", "max", "center", "radius", "side", "at", "path"):
                yield folder, with_change(scene, path, dict.pop), (*path, "missing")
    rest = [key for key in schemas if key not in done and "disc" not in key and "circle" not in key]
    assert len(rest) < 20, rest


SCENE, STUDY = schema_of("schema"), schema_of("study.schema")


class Schemas(unittest.TestCase):
    def setUp(self):
        self.addCleanup(os.chdir, os.getcwd())
        warnings.simplefilter("ignore", sph2d.SceneWarning)

    def test_files(self):
        """What is in this tree is what the schemas ask for."""
        found = {"scene": 0, "study": 0}
        for name in glob.glob(f"{ROOT}/**/*.yaml", recursive=True):
            if re.match("(examples|tests/(restarts|hard|cases)|cli/play)/", os.path.relpath(name, ROOT)):
                text = read(name)
                kind = "study" if "scene" in text else "scene"
                self.assertEqual(faults(STUDY if kind == "study" else SCENE, text), [], name)
                found[kind] += 1
        self.assertGreater(min(found.values()), 80)

    def test_pages(self):
        pieces = 0
        for page in [*glob.glob(f"{ROOT}/docs/*.md"), f"{ROOT}/README.md"]:
            with open(page, encoding="utf-8") as file:
                for piece in re.findall(r"^```yaml$(.*?)^```$", file.read(), re.M | re.S):
                    text = yaml.load(piece, Loader)
                    schema = STUDY if "scene" in text else SCENE
                    self.assertEqual(faults(schema, text if schema is STUDY else WHOLE | text), [], (page, piece))
                    pieces += 1
        self.assertGreater(pieces, 7)

    def test_faults(self):
        """What a schema refuses the reader refuses, and the other way round, where a single key is at fault."""
        cases = 0
        for folder, scene, what in faulty_scenes():
            os.chdir(folder)
            with self.subTest(what):
                errors = ()
                try:
                    sph2d.Scene(scene)
                except sph2d.Error as error:
                    errors = error.diagnostics
                found = faults(SCENE, scene)
                if what[0] == "probes" and what[-1] == "missing" and what[-2] in ("at", "path"):
                    self.assertEqual((found, [d.path for d in errors]), ([], [f"probes[{what[1]}].at"]))  # of some kinds
                elif what[-1] == "end":  # which may be wrong beside other keys
                    self.assertEqual((found, [d.text for d in errors if "out of range" in d.message]), ([], []))
                else:
                    self.assertEqual(bool(found), any(d.code in KEYS for d in errors), (found, errors))
            cases += 1
        self.assertGreater(cases, 900)

    def test_either(self):
        """Keys that exclude each other, short forms, other words, values on or off."""
        box, disc = {"min": [0, 0], "max": [1, 1]}, {"center": [1, 1], "radius": 0.1}
        for more, sound in [({"blocks": [{"box": box}]}, True), ({"blocks": [{"disc": disc}]}, True),
                            ({"blocks": [{"box": box, "disc": disc}]}, False), ({"blocks": [{"circle": disc, "disc": disc}]}, False),
                            ({"fluid": "water"}, True), ({"fluid": "wate"}, False), ({"method": "pcisph"}, True),
                            ({"domain": "water"}, False), ({"wall_slip": "none"}, True), ({"spacing": 0}, False),
                            ({"run": {"frames": {"size": [64, 64.5]}}}, False), ({"method": {"cfl": 0}}, True),
                            ({"method": {"cfl": 0.001}}, False)]:
            self.assertEqual(faults(SCENE, WHOLE | more) == [], sound, more)


if __name__ == "__main__":
    unittest.main()
