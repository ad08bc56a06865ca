# The Python package, installed as its users do.

python_package() {
  # Of the profile that is compiled already.
  MATURIN_PEP517_ARGS="--profile dev" scripts/check_python.sh --torch "$work/package"
  # What one of them began the other goes on with.
  diff <("$program" --version) <("$work/package/bin/endless" --version)
  "$work/package/bin/python" scripts/run_doc_examples.py "$work/out" docs/python.md docs/sim2real.md docs/layers/*.md
  "$work/package/bin/python" scripts/train_from_stream.py
  if has_ray; then "$work/package/bin/python" scripts/judge_ray.py; fi
}

# Against a server that speaks S3, and Azure's emulator. Only the package's program has object storage.
object_storage() {
  "$python" scripts/judge_storage.py "$work/package/bin/endless"
  "$python" scripts/judge_azure.py "$work/package/bin/endless" "$work/browser"
}
