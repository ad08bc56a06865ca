#!/usr/bin/env python3
"""Reads what `endless cluster kubernetes` writes with a parser of YAML (PyYAML), and checks what the Job needs.

    endless cluster kubernetes recipe.toml ... | python3 scripts/check_manifest.py RECIPE SHARDS
"""

import sys

import yaml


def main() -> None:
    recipe, shards = open(sys.argv[1]).read(), int(sys.argv[2])
    config, job = yaml.safe_load_all(sys.stdin)
    assert config["kind"] == "ConfigMap" and config["data"]["recipe.toml"] == recipe, "the recipe as it is"
    spec = job["spec"]
    assert job["apiVersion"] == "batch/v1" and job["kind"] == "Job"
    assert spec["completionMode"] == "Indexed" and spec["completions"] == shards
    assert isinstance(spec["backoffLimitPerIndex"], int)
    pod = spec["template"]["spec"]
    # Both are asked for by the server where an index has a limit of its own.
    assert pod["restartPolicy"] == "Never"
    volumes = {volume["name"]: volume for volume in pod["volumes"]}
    (container,) = pod["containers"]
    assert {mount["name"] for mount in container["volumeMounts"]} == set(volumes), "all volumes are mounted"
    assert volumes["recipe"]["configMap"]["name"] == config["metadata"]["name"]
    (command,) = container["args"]
    assert f'--shard "$((JOB_COMPLETION_INDEX + 1))/{shards}"' in command, command
    assert container["resources"]["requests"].keys() == {"cpu", "memory"}
    print(f"a Job of {shards} shards: {command}")


if __name__ == "__main__":
    main()
