"""check_schema.py SCHEMA FOLDER - every FOLDER/*/report.json holds to SCHEMA, damaged ones do not.

Exit codes: 0 fine, 1 a report or the schema is wrong, 77 python3-jsonschema is absent (a skip).
"""

import copy
import json
import pathlib
import sys

try:
    from jsonschema import Draft202012Validator
except ImportError:
    print("skipped: python3-jsonschema is absent (apt-get install python3-jsonschema)")
    sys.exit(77)


def paths_of(value, path=()):
    """The path of every member of every object in `value`."""
    if isinstance(value, dict):
        for key, member in value.items():
            yield path + (key,)
            yield from paths_of(member, path + (key,))
    elif isinstance(value, list):
        for index, member in enumerate(value):
            yield from paths_of(member, path + (index,))


def parent_of(value, path):
    for step in path[:-1]:
        value = value[step]
    return value


def is_free(path):
    """Whether the member may be missing: its name is data (a model, a counter, an intermediate
    value), or it is only there for scenes of the whole unit."""
    if path == ("unit",):
        return True
    if path[:2] == ("unit", "timings") or path[:2] == ("timing", "unit"):
        return len(path) == 3
    return "counters" in path[:-1] or "values" in path[:-1] or path[-2:-1] == ("models",)


def damaged(report):
    """Copies of the report, each wrong in one member: left out, of a wrong type, or misspelt."""
    for path in paths_of(report):
        if not is_free(path):
            without = copy.deepcopy(report)
            del parent_of(without, path)[path[-1]]
            yield path, "left out", without
        wrong = copy.deepcopy(report)
        flags = ("agree", "estimate", "counters", "duplicate_lines", "half_vector", "keep_cache",
                 "draw_twice", "sources_changed")
        parent_of(wrong, path)[path[-1]] = "yes" if path[-1] in flags else True
        yield path, "of a wrong type", wrong
    misspelt = copy.deepcopy(report)
    misspelt["diferences"] = []
    yield ("diferences",), "unknown", misspelt


def main():
    schema = json.loads(pathlib.Path(sys.argv[1]).read_text(encoding="utf-8"))
    Draft202012Validator.check_schema(schema)
    validator = Draft202012Validator(schema)
    reports = sorted(pathlib.Path(sys.argv[2]).glob("*/report.json"))
    assert len(reports) >= 6, f"found {len(reports)} reports, expected six kinds"
    faults = 0
    for file in reports:
        for error in validator.iter_errors(json.loads(file.read_text(encoding="utf-8"))):
            faults += 1
            print(f"{file}: {error.json_path}: {error.message}")
    tried = 0
    for kind in ("faulty", "unit_late"):
        whole = json.loads((reports[0].parents[1] / kind / "report.json").read_text("utf-8"))
        whole["worst"] = whole["worst"][:1]
        for path, how, report in damaged(whole):
            tried += 1
            if validator.is_valid(report):
                faults += 1
                print(f"the schema accepts a report whose {'.'.join(map(str, path))} is {how}")
    print(f"{len(reports)} reports, {tried} damaged ones, {faults} faults")
    return 1 if faults or tried < 100 else 0


if __name__ == "__main__":
    sys.exit(main())
