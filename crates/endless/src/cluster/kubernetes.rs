//! A manifest for Kubernetes.

use super::quoted;
use crate::args::KubernetesArgs;

/// Where the volume is mounted.
const DATA: &str = "/data";

/// A Job with an index a shard, and the recipe as a ConfigMap. Texts are written as JSON has them, which YAML reads.
pub(super) fn manifest(args: &KubernetesArgs, recipe: &str) -> String {
    let shards = &args.shards;
    let (name, number) = (&shards.name, shards.shards);
    let out = place(args);
    let generate = format!(
        "exec endless generate {} --config /recipe/recipe.toml --shard \"$((JOB_COMPLETION_INDEX + 1))/{number}\" --threads {}",
        quoted(&out),
        shards.cpus
    );
    let environment = args.secret.as_ref().map(|secret| {
        format!("          envFrom:\n            - secretRef:\n                name: {}\n", text(secret))
    });
    let mount = args.claim.as_ref().map(|_| format!("            - name: data\n              mountPath: {DATA}\n"));
    let volume = args.claim.as_ref().map(|claim| {
        format!("        - name: data\n          persistentVolumeClaim:\n            claimName: {}\n", text(claim))
    });
    let (environment, mount, volume) =
        (environment.unwrap_or_default(), mount.unwrap_or_default(), volume.unwrap_or_default());
    format!(
        r#"# {number} shards of one dataset, written by `endless cluster kubernetes`. Start it with `kubectl apply -f FILE`, and wait with
# `kubectl wait --for=condition=complete --timeout=-1s job/{name}`. A pod that is lost is tried again by itself and goes on where
# it was. When all are complete, `endless check OUT --shards {number}` reads the whole.
apiVersion: v1
kind: ConfigMap
metadata:
  name: {map}
data:
  recipe.toml: {recipe}
---
apiVersion: batch/v1
kind: Job
metadata:
  name: {name_text}
spec:
  completionMode: Indexed
  completions: {number}
  parallelism: {number}
  backoffLimitPerIndex: {retries}
  podFailurePolicy:
    rules:
      # A node that is drained or taken away is nobody's fault.
      - action: Ignore
        onPodConditions:
          - type: DisruptionTarget
            status: "True"
      # A recipe or an option that cannot be does not get better.
      - action: FailIndex
        onExitCodes:
          containerName: endless
          operator: In
          values: [2]
  template:
    metadata:
      labels:
        app: {name_text}
    spec:
      restartPolicy: Never
      containers:
        - name: endless
          image: {image}
          command: ["/bin/sh", "-c"]
          args:
            - {generate}
{environment}          resources:
            requests:
              cpu: {cpus}
              memory: {memory}
            limits:
              memory: {memory}
          volumeMounts:
            - name: recipe
              mountPath: /recipe
              readOnly: true
{mount}      volumes:
        - name: recipe
          configMap:
            name: {map}
{volume}"#,
        map = text(&format!("{name}-recipe")),
        name_text = text(name),
        recipe = text(recipe),
        image = text(&args.image),
        generate = text(&generate),
        cpus = text(&shards.cpus.to_string()),
        memory = text(&args.memory),
        retries = args.retries,
    )
}

/// A folder is one of the volume.
fn place(args: &KubernetesArgs) -> String {
    let out = &args.shards.out;
    if args.claim.is_none() || out.contains("://") || out.starts_with('/') {
        return out.clone();
    }
    format!("{DATA}/{out}")
}

/// A text in quotes.
fn text(text: &str) -> String {
    serde_json::Value::from(text).to_string()
}
