"""The types that the module declares are those of what it gives. tests/python/wheel.sh has mypy check a program."""
import inspect
import typing
import unittest

import common
from common import raft, sph2d, tank

# What structs have beside the fields of their named tuples.
WITHOUT = {"densities": {"status"}, "snapshot_info": {"fluid", "frames"}}


def public():
    """(name, function) of each call that a program may use."""
    for name in sph2d.__all__:
        thing = getattr(sph2d, name)
        if inspect.isfunction(thing):
            yield name, thing
        for member, value in vars(thing).items():
            function = value.fget if isinstance(value, property) else value
            written = inspect.isfunction(function) and not function.__code__.co_filename.startswith("<")
            if written and (member == "__init__" or not member.startswith("_")):
                yield f"{name}.{member}", function


class Types(common.InFolder):
    def setUp(self):
        super().setUp()
        common.ignore_warnings(self)

    def check(self, record):
        """A named tuple has the types that it declares."""
        kinds = typing.get_type_hints(type(record))
        for name, value in record._asdict().items():
            kind = kinds[name]
            if hasattr(value, "_fields"):
                self.assertIs(kind, type(value), name)
                self.check(value)
                continue
            allowed = typing.get_args(kind) if typing.get_origin(kind) is typing.Union else (kind,)
            if typing.get_origin(kind) is tuple:
                self.assertEqual(tuple(map(type, value)), typing.get_args(kind), name)
            else:
                self.assertIn(type(value), allowed, name)

    def test_records_are_the_structs(self):
        self.assertEqual(len(sph2d._RECORDS), 8)
        for struct, record in sph2d._RECORDS.items():
            name = struct.__name__[len("sph2d_"):]
            fields = [field for field, _ in struct._fields_ if field not in WITHOUT.get(name, ())]
            self.assertEqual(list(record._fields), fields, name)

    def test_records_have_their_types(self):
        sim = sph2d.Simulation(raft())
        sim.step()
        sim.write_snapshot("a.h5")
        for record in (*sph2d.devices(), sim.summary(), sim.plan, sim.body(0), sim.densities(), sph2d.Snapshot("a.h5").info):
            self.check(record)
        with self.assertRaises(sph2d.Error) as caught:
            sph2d.Scene({"spacing": 1})
        self.check(caught.exception.diagnostics[0])

    def test_fields_of_two_components(self):
        pairs = set()
        for method in ("wcsph", "constraint", "pcisph", "hybrid", "muller"):
            sim = sph2d.Simulation(tank(method=method))
            sim.step()
            sim.write_snapshot("a.h5")
            snapshot = sph2d.Snapshot("a.h5")
            pairs |= {name for group in ("fluid", "wall", "run", "outline") for name in snapshot.names(group)
                      if isinstance(snapshot.field(name, group), tuple)}
        self.assertLessEqual(pairs, set(typing.get_args(sph2d._Pairs)))
        self.assertIn("StrainRates", pairs)

    def test_all_is_annotated(self):
        found = list(public())
        self.assertGreater(len(found), 40)
        for name, function in found:
            signature = inspect.signature(function)
            self.assertIsNot(signature.return_annotation, inspect.Signature.empty, name)
            for parameter in list(signature.parameters.values())[("." in name):]:
                self.assertIsNot(parameter.annotation, inspect.Parameter.empty, (name, parameter.name))


if __name__ == "__main__":
    unittest.main()
