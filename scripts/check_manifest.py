#!/usr/bin/env python3
"""Checks what `endless cluster kubernetes` writes: with a parser of YAML, by the schemas of Kubernetes' own API, strictly, and what the
Job needs.

    pip install pyyaml kubernetes-validate
    endless cluster kubernetes recipe.toml ... | python3 scripts/check_manifest.py RECIPE SHARDS
"""

import sys

import kubernetes_validate
import yaml

# The oldest that knows all fields, and the latest.
VERSIONS = ["1.29", kubernetes_validate.latest_version()]


def main() -> None:
    recipe, shards = open(sys.argv[1]).read(), int(sys.argv[2])
    config, job = documents = list(yaml.safe_load_all(sys.stdin))
    for version in VERSIONS:
        for document in documents:
            kubernetes_validate.validate(document, version, strict=True)
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
    print(f"a Job of {shards} shards, by the schemas of {' and '.join(VERSIONS)}: {command}")


if __name__ == "__main__":
    main()
