//! A script for Slurm that submits itself.

use super::quoted;
use crate::args::SlurmArgs;

/// The script. Started by hand it queues itself as an array of jobs, and a check that comes when all have ended.
pub(super) fn script(args: &SlurmArgs, recipe: &str, out: &str) -> String {
    let shards = &args.shards;
    let at_once = args.at_once.map(|count| format!("%{count}")).unwrap_or_default();
    let mut options = vec![
        format!("--job-name={}", shards.name),
        format!("--array=1-{}{at_once}", shards.shards),
        "--ntasks=1".to_owned(),
        format!("--cpus-per-task={}", shards.cpus),
        format!("--time={}", args.time),
        format!("--output={}-%A_%a.log", shards.name),
        "--open-mode=append".to_owned(),
        "--requeue".to_owned(),
        "--signal=B:USR1@120".to_owned(),
    ];
    let mut of_both = Vec::new();
    of_both.extend(args.partition.as_ref().map(|name| format!("--partition={name}")));
    of_both.extend(args.account.as_ref().map(|name| format!("--account={name}")));
    options.extend(of_both.clone());
    options.extend(args.mem.as_ref().map(|size| format!("--mem={size}")));
    let options: String = options.iter().map(|option| format!("#SBATCH {option}\n")).collect();
    let check_options: String = of_both.iter().map(|option| format!(" {option}")).collect();
    let (program, out, recipe) = (quoted(&args.program), quoted(out), quoted(recipe));
    let (name, number) = (&shards.name, shards.shards);
    let check = quoted(&format!("{program} check {out} --shards {number}"));
    format!(
        r#"#!/bin/bash
# {number} shards of one dataset, written by `endless cluster slurm`. Submit it with `bash SCRIPT`: that also queues a check for
# when all have ended. A shard that failed is made again by `sbatch --array=NUMBER SCRIPT`, and goes on where it was.
{options}set -euo pipefail

if [[ -z ${{SLURM_ARRAY_TASK_ID:-}} ]]; then
    array=$(sbatch --parsable "$0")
    array=${{array%%;*}}
    check=$(sbatch --parsable --dependency=afterany:"$array" --job-name={name}-check --ntasks=1 --requeue \
        --output={name}-check-%j.log{check_options} --wrap={check})
    echo "queued: $array, an array of {number} shards, and ${{check%%;*}}, the check after it"
    exit
fi

# What a shard has finished stays, so it may be stopped at any time and goes on in the queue's next turn.
stop() {{
    trap '' TERM INT USR1
    kill -TERM "$shard" 2>/dev/null || true
    wait "$shard" || true
}}
# Two minutes before the time is over.
again() {{
    stop
    echo "shard $SLURM_ARRAY_TASK_ID/{number} is queued again"
    scontrol requeue "${{SLURM_ARRAY_JOB_ID}}_${{SLURM_ARRAY_TASK_ID}}"
    exit 0
}}
# Cancelled, or preempted: then Slurm queues it again by itself.
ended() {{
    stop
    exit 143
}}
trap again USR1
trap ended TERM INT

{program} generate {out} --config {recipe} --shard "$SLURM_ARRAY_TASK_ID/{number}" \
    --threads "${{SLURM_CPUS_PER_TASK:-{cpus}}}" &
shard=$!
wait "$shard"
"#,
        cpus = shards.cpus,
    )
}
