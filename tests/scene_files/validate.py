#!/usr/bin/env python3
"""Exports scenes with the carom command and holds the files against the JSON Schema, and spoils them in ways that the schema and the reader must both
refuse.

usage: validate.py CAROM SCHEMA
"""
import copy
import json
import subprocess
import sys
import tempfile
from pathlib import Path

try:
    import jsonschema
except ImportError:
    jsonschema = None

# A size at which each scene is small; others take 5.
SIZES = {"platformer": 40}
# The rest of a long list is like its beginning.
MOST = {"bodies": 400, "events": 2}
NAMED = ["gravity", "collisions", "card-house", "joints", "chain-terrain", "planets", "triggers", "ragdolls"]


class Small:
    """As much of JSON Schema as the schema of scene files uses, for where the library is not installed."""

    TYPES = {"object": dict, "array": list, "string": str, "boolean": bool, "integer": int, "number": (int, float), "null": type(None)}

    def __init__(self, root):
        self.root = root

    def is_valid(self, value, schema=None):
        schema = self.root if schema is None else schema
        if "$ref" in schema:
            target = self.root
            for part in schema["$ref"].split("/")[1:]:
                target = target[part]
            if not self.is_valid(value, target):
                return False
        if "type" in schema:
            is_bool = isinstance(value, bool)
            if not isinstance(value, self.TYPES[schema["type"]]) or (is_bool and schema["type"] != "boolean"):
                return False
        if "enum" in schema and value not in schema["enum"]:
            return False
        if isinstance(value, (int, float)) and not isinstance(value, bool):
            if value < schema.get("minimum", value) or value > schema.get("maximum", value):
                return False
            if "exclusiveMinimum" in schema and value <= schema["exclusiveMinimum"]:
                return False
        if isinstance(value, list):
            if not schema.get("minItems", 0) <= len(value) <= schema.get("maxItems", len(value)):
                return False
            if "items" in schema and not all(self.is_valid(item, schema["items"]) for item in value):
                return False
        if isinstance(value, dict):
            properties = schema.get("properties", {})
            if any(name not in value for name in schema.get("required", [])):
                return False
            if schema.get("additionalProperties") is False and any(name not in properties for name in value):
                return False
            if not all(self.is_valid(value[name], properties[name]) for name in value if name in properties):
                return False
        if "anyOf" in schema and not any(self.is_valid(value, s) for s in schema["anyOf"]):
            return False
        if "oneOf" in schema and sum(self.is_valid(value, s) for s in schema["oneOf"]) != 1:
            return False
        return "not" not in schema or not self.is_valid(value, schema["not"])


def objects_in(value, path=()):
    """The ways to all objects in a value, the outermost first."""
    if isinstance(value, dict):
        yield path
    items = value.items() if isinstance(value, dict) else enumerate(value) if isinstance(value, list) else ()
    for key, inner in items:
        yield from objects_in(inner, path + (key,))


def spoilt(scene):
    """Scenes that differ from a good one by a field that is unknown, missing or of the wrong type, and what was done."""
    seen = set()
    for path in objects_in(scene):
        kind = tuple(key for key in path if isinstance(key, str))
        if kind in seen:
            continue  # the next body is like the last one
        seen.add(kind)
        for what in ("unknown", "wrong type"):
            copied = copy.deepcopy(scene)
            at = copied
            for key in path:
                at = at[key]
            if what == "unknown":
                at["no_such_field"] = 1
            elif at:
                at[next(iter(at))] = {"no": "such value"}
            else:
                continue
            yield copied, f"{what} at {path}"


def main():
    carom, schema_path = sys.argv[1], sys.argv[2]
    schema = json.loads(Path(schema_path).read_text(encoding="utf-8"))
    validators = [Small(schema)]
    if jsonschema:
        jsonschema.Draft202012Validator.check_schema(schema)
        validators.append(jsonschema.Draft202012Validator(schema))
    complaints = []
    with tempfile.TemporaryDirectory() as folder:
        file = str(Path(folder, "scene.json"))

        def reads(scene):
            Path(file).write_text(json.dumps(scene), encoding="utf-8")
            return subprocess.run([carom, "run", file, "--steps", "1"], capture_output=True, check=False).returncode == 0

        listed = json.loads(subprocess.run([carom, "export", "--list", "--json"], capture_output=True, check=True).stdout)
        arguments = [[s["name"], "--set", f"size={max(s['size']['range'][0], SIZES.get(s['name'], 5))}"] for s in listed]
        for scene_arguments in arguments + [[name] for name in NAMED]:
            subprocess.run([carom, "export", scene_arguments[0], file, *scene_arguments[1:]], capture_output=True, check=True)
            scene = json.loads(Path(file).read_text(encoding="utf-8"))
            for name, most in MOST.items():
                scene[name] = scene.get(name, [])[:most]
            complaints += [f"{scene_arguments[0]}: {type(v).__name__} refuses it" for v in validators if not v.is_valid(scene)]
            if scene_arguments[0] not in ("rain", "joints", "spinner", "platformer", "orbits_1000"):
                continue
            if not reads(scene):
                complaints.append(f"{scene_arguments[0]}: the reader refuses it")
            for bad, what in spoilt(scene):
                complaints += [f"{scene_arguments[0]}: {type(v).__name__} takes {what}" for v in validators if v.is_valid(bad)]
                if reads(bad):
                    complaints.append(f"{scene_arguments[0]}: the reader takes {what}")
    print("\n".join(complaints) if complaints else f"scene files: all as the schema has it ({len(validators)} validators)")
    return 1 if complaints else 0


if __name__ == "__main__":
    sys.exit(main())
