# What comes from the network: packages of Python, a browser. Nothing here computes for long.

# One environment with all that judges datasets, resolved once.
judges_packages() {
  install_packages "$work/venv" numpy pillow pycocotools typos pykitti pandas opencv-python-headless plyfile pyyaml kubernetes-validate trackeval \
    cityscapesscripts webdataset pyarrow datasets tfrecord nuscenes-devkit ultralytics rerun-sdk datumaro mlcroissant \
    huggingface_hub "moto[server]" boto3 trustme azure-storage-blob carla==0.9.16
}

# What the Python package is tested with. The package itself is installed by pip.
package_tools() {
  local engines=()
  if has_ray; then engines=("ray[data]"); fi
  install_packages "$work/package" numpy pytest hypothesis pillow pyyaml pycocotools mypy pyright torch torchvision "${engines[@]}"
}

# uv keeps what both environments need, such as torch, once.
install_packages() {
  local environment=$1
  shift
  python3 -m venv "$environment"
  UV_CACHE_DIR="$work/uv_cache" "$work/uv/bin/uv" pip install --quiet --python "$environment/bin/python" "$@"
}

python_packages() {
  python3 -m venv "$work/uv"
  "$work/uv/bin/pip" install --quiet uv
  judges_packages
  package_tools
}

browser_packages() {
  local missing=()
  command -v chromium >/dev/null || missing+=(chromium)
  command -v npm >/dev/null || missing+=(nodejs npm)
  # And Slurm.
  if [ -n "${ENGINES:-}" ]; then missing+=(slurm-wlm munge); fi
  if [ ${#missing[@]} -gt 0 ]; then
    apt-get update -qq
    DEBIAN_FRONTEND=noninteractive apt-get install -y -qq --no-install-recommends "${missing[@]}" >/dev/null
  fi
  npm install --silent --no-audit --no-fund --prefix "$work/browser" playwright-core azurite
}

# Engines are judged where the machine has them; ENGINES=1 installs them.
has_ray() { [ -n "${ENGINES:-}" ] || python3 -c "import ray" 2>/dev/null; }
has_slurm() { [ "$(id -u)" = 0 ] && command -v slurmctld >/dev/null; }
