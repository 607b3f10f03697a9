"""The names of the module for docs/python.md, each with its signature and the first sentence of its documentation:
`make python-docs` prints them."""
import inspect
import re

from common import sph2d


def sentence(thing):
    """The first sentence of a documentation."""
    text = " ".join((inspect.getdoc(thing) or "").split("\n\n")[0].split())
    return re.match(r"(.*?\.)(?= |$)|.*", text).group().replace("|", r"\|")


def members(kind):
    """(name, member) of what a class has of the module itself, in the order of the source, its bases last."""
    found = {}
    for base in kind.__mro__:
        if base.__module__.startswith("sph2d"):
            for name, member in vars(base).items():
                public = not name.startswith("_") and (inspect.isfunction(member) or isinstance(member, property))
                if public and name not in getattr(kind, "_fields", ()):
                    found.setdefault(name, member)
    return found.items()


def public():
    """(name, thing) of all that a program may use."""
    for name in sph2d.__all__:
        thing = getattr(sph2d, name)
        yield name, thing
        if inspect.isclass(thing):
            yield from ((f"{name}.{member}", value) for member, value in members(thing))


def signature(name, function):
    """The call of a function, with types and defaults."""
    known, given, keyword_only = inspect.signature(function), [], False
    for parameter in known.parameters.values():
        if parameter.name == "self":
            continue
        if parameter.kind == parameter.KEYWORD_ONLY and not keyword_only:
            keyword_only = True
            given.append("*")
        text = f"{'**' if parameter.kind == parameter.VAR_KEYWORD else ''}{parameter.name}: {parameter.annotation}"
        given.append(text if parameter.default is parameter.empty else f"{text} = {parameter.default!r}")
    result = known.return_annotation
    return f"{name}({', '.join(given)})" + (f" -> {result}" if result not in (None, "None") else "")


def rows(kind):
    """The lines of a class."""
    for name, member in members(kind):
        is_property = isinstance(member, property)
        told = f"{name}: {member.fget.__annotations__['return']}" if is_property else signature(name, member)
        yield f"| `{told}` | {sentence(member)} |"


def page():
    lines = []
    for name in sph2d.__all__:
        thing = getattr(sph2d, name)
        fields = getattr(thing, "_fields", None) or getattr(thing, "__slots__", None) or {
            field: 0 for field in vars(thing).get("__annotations__", {})}
        takes = inspect.isfunction(thing) or thing.__module__ == "sph2d" and not fields and "__init__" in vars(thing)
        call = signature(name, thing if inspect.isfunction(thing) else thing.__init__) if takes else name
        lines += [f"### `{call}`", "", sentence(thing)]
        if fields:
            lines += ["", "Has " + ", ".join(f"`{field}`" for field in fields) + "."]
        table = list(rows(thing)) if inspect.isclass(thing) else []
        lines += ["", "| | |", "|---|---|", *table, ""] if table else [""]
    return "\n".join(lines)


if __name__ == "__main__":
    print(page(), end="")
