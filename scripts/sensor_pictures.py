#!/usr/bin/env python3
"""Makes the pictures of docs/radar.md, docs/event_camera.md, docs/imu.md and docs/gnss.md from a drive through Town03.

    python3 scripts/sensor_pictures.py ENDLESS FOLDER [DATASET]

ENDLESS is the program. DATASET is where the drive is kept; it is made if it is not there. Needs NumPy, Pillow and Matplotlib.
"""

import json
import pathlib
import subprocess
import sys
import tempfile

import matplotlib

matplotlib.use("Agg")
import matplotlib.pyplot as plt  # noqa: E402
import numpy as np  # noqa: E402
from PIL import Image  # noqa: E402

TOWN, FPS, SECONDS = "Town03", 20, 20
# Where the town lies, degrees north and east.
ORIGIN = (40.6, -80.1)
# An IMU and a receiver as cars have them.
RIG = """
[[sensor]]
name = "front"
type = "camera"
size = "1000x562"
fov = 70
rate = 2
layers = ["rgb"]
mount = {{ on = "vehicle", class = "car", number = 7, at = [1.6, 0.0, 1.3] }}
[[sensor]]
name = "radar"
type = "radar"
rate = 2
horizontal_fov = 70
vertical_fov = 14
points_per_second = 400
mount = {{ on = "vehicle", class = "car", number = 7, at = [2.2, 0.0, 0.6] }}
[[sensor]]
name = "events"
type = "event_camera"
size = "500x281"
fov = 70
mount = {{ on = "vehicle", class = "car", number = 7, at = [1.6, 0.0, 1.3] }}
[[sensor]]
name = "imu"
type = "imu"
mount = {{ on = "vehicle", class = "car", number = 7, at = [0.0, 0.0, 0.5] }}
[[sensor]]
name = "noisy_imu"
type = "imu"
mount = {{ on = "vehicle", class = "car", number = 7, at = [0.0, 0.0, 0.5] }}
{imu_noise}
[[sensor]]
name = "gnss"
type = "gnss"
rate = 4
mount = {{ on = "vehicle", class = "car", number = 7, at = [0.0, 0.0, 1.5] }}
noise_lat_stddev = 1.8e-5
noise_lon_stddev = 2.4e-5
"""
IMU_NOISE = "".join(f"noise_accel_stddev_{axis} = 0.1\nnoise_gyro_stddev_{axis} = 0.01\n" for axis in "xyz")


def lines(path):
    return [json.loads(line) for line in path.read_text().splitlines()]


def drive(endless, out):
    with tempfile.TemporaryDirectory() as folder:
        rig = pathlib.Path(folder) / "rig.toml"
        rig.write_text(RIG.format(imu_noise=IMU_NOISE))
        where = ["--maps", TOWN, "--weathers", "clear_sky", "--times", "afternoon", "--vehicles", "120", "--seed", "5"]
        how = ["--rig", str(rig), "--cameras-per-scene", "0", "--videos", "1", "--fps", str(FPS), "--duration", str(SECONDS)]
        subprocess.run([endless, "generate", str(out), *where, *how, "--camera-look", "clean", "--mp4", "none"], check=True)
    return next((out / "videos").iterdir())


def save(figure, path):
    figure.savefig(path, dpi=100, pil_kwargs={"quality": 85})
    plt.close(figure)


def radar(video, path):
    """Detections over the picture: where, how fast, how strong."""
    camera = {line["frame"]: line for line in lines(video / "front/poses.jsonl")}
    radar_poses = {line["frame"]: line for line in lines(video / "radar/poses.jsonl")}

    def moving(frame):
        scan = np.genfromtxt(video / f"radar/scans/{frame:06}.csv", delimiter=",", names=True, ndmin=1)
        return np.unique(scan["id"][(scan["id"] > 0) & (scan["depth_m"] < 50)]).size

    frame = max(camera, key=moving)
    scan = np.genfromtxt(video / f"radar/scans/{frame:06}.csv", delimiter=",", names=True, ndmin=1)
    level = scan["depth_m"] * np.cos(scan["altitude_rad"])
    points = np.stack([level * np.cos(scan["azimuth_rad"]), level * np.sin(scan["azimuth_rad"]),
                       scan["depth_m"] * np.sin(scan["altitude_rad"])], 1)
    # Both look ahead: only the place differs.
    apart = np.array(radar_poses[frame]["position"]) - camera[frame]["position"]
    rotation = np.array(camera[frame]["world_from_camera"])[:3, :3]
    body_from_camera = np.array([[0, 0, 1], [-1, 0, 0], [0, -1, 0]])
    seen = points @ body_from_camera + apart @ rotation
    lens = camera[frame]["intrinsics"]
    x = lens["cx"] + lens["fx"] * seen[:, 0] / seen[:, 2]
    y = lens["cy"] + lens["fy"] * seen[:, 1] / seen[:, 2]
    image = Image.open(video / f"front/rgb/{frame:06}.png")
    figure = plt.figure(figsize=(10, 6.24))
    axes = figure.add_axes((0, 0.62 / 6.24, 1, 5.62 / 6.24))
    axes.imshow(image)
    speed = max(3.0, np.abs(scan["velocity_mps"]).max())
    dots = axes.scatter(x, y, s=np.clip(6 * (scan["power_db"] + 78), 12, 260), c=scan["velocity_mps"], cmap="coolwarm_r", vmin=-speed,
                        vmax=speed, edgecolors="black", linewidths=0.8, alpha=0.9)
    axes.set(xlim=(0, image.width), ylim=(image.height, 0))
    axes.axis("off")
    bar = figure.colorbar(dots, cax=figure.add_axes((0.2, 0.07, 0.6, 0.02)), orientation="horizontal")
    bar.set_label("radial velocity, m/s (negative: comes nearer); size: power", labelpad=1, fontsize=9)
    save(figure, path)


def events(video, path):
    """A picture, and the events of the twentieth of a second that ends with it."""
    files = sorted((video / "events/events").glob("*.npy"))
    frames = [int(image.stem) for image in sorted((video / "front/rgb").glob("*.png"))][1:]
    frame = max(frames, key=lambda frame: files[frame].stat().st_size if files[frame].stat().st_size < 900_000 else 0)
    happened = np.load(files[frame])
    picture = np.full((281, 500, 3), 235, np.uint8)
    picture[happened["y"], happened["x"]] = np.where(happened["pol"][:, None], [30, 90, 220], [215, 50, 40])
    photo = Image.open(video / f"front/rgb/{frame:06}.png").convert("RGB").resize((500, 281), Image.Resampling.LANCZOS)
    both = Image.new("RGB", (1004, 281), "white")
    both.paste(photo, (0, 0))
    both.paste(Image.fromarray(picture), (504, 0))
    both.save(path, quality=88)


def imu(video, path):
    """Curves with and without noise."""
    figure, all_axes = plt.subplots(3, 1, figsize=(10, 6), sharex=True)
    for name, style in (("noisy_imu", {"color": "#c9b18f", "lw": 0.9}), ("imu", {"color": "#1f4e9c", "lw": 1.4})):
        samples = lines(video / name / "imu.jsonl")
        time = [sample["time_s"] for sample in samples]
        force = np.array([sample["accelerometer_mps2"] for sample in samples])
        rate = np.array([sample["gyroscope_radps"] for sample in samples])
        label = {"imu": "without noise", "noisy_imu": "with noise"}[name]
        for axes, values in zip(all_axes, (force[:, 0], force[:, 1], rate[:, 2])):
            axes.plot(time, values, label=label, **style)
    for axes, title in zip(all_axes, ("forward, m/s²", "to the left, m/s²", "turn about z, rad/s")):
        axes.set_ylabel(title)
        axes.grid(alpha=0.3)
        axes.margins(x=0)
    all_axes[0].legend(loc="upper right", ncols=2)
    all_axes[2].set_xlabel("seconds")
    figure.align_ylabels()
    figure.tight_layout()
    save(figure, path)


def gnss(endless, video, path):
    """Fixes over the map."""
    poses = lines(video / "gnss/poses.jsonl")
    fixes = lines(video / "gnss/gnss.jsonl")
    way = np.array([pose["position"][:2] for pose in poses])
    with tempfile.TemporaryDirectory() as folder:
        roads = pathlib.Path(folder) / "roads.geojson"
        subprocess.run([endless, "maps", "export", TOWN, "--geojson", str(roads)], check=True, stdout=subprocess.DEVNULL)
        features = json.loads(roads.read_text())["features"]
    lat, lon = (np.radians([fix[key] for fix in fixes]) for key in ("latitude_deg", "longitude_deg"))
    # Metres on the ellipsoid near the map's origin.
    north0, east0 = np.radians(ORIGIN)
    e2, a = 0.00669437999014, 6378137.0
    across = a / np.sqrt(1 - e2 * np.sin(north0) ** 2)
    along = across * (1 - e2) / (1 - e2 * np.sin(north0) ** 2)
    found = np.stack([(lon - east0) * across * np.cos(lat), (lat - north0) * along], 1)
    figure, axes = plt.subplots(figsize=(10, 6))
    for feature in features:
        kind, shape = feature["properties"].get("kind") or feature["properties"].get("type"), feature["geometry"]
        if shape["type"] == "LineString":
            axes.plot(*np.array(shape["coordinates"])[:, :2].T, color="#b9bec6", lw=1)
        elif shape["type"] == "Polygon":
            axes.fill(*np.array(shape["coordinates"][0])[:, :2].T, color="#e8e3d8" if kind == "building" else "#eef1ee", lw=0)
    axes.plot(*way.T, color="#1f4e9c", lw=2, label="where the antenna was")
    axes.scatter(*found.T, s=12, color="#d1462f", zorder=3, label="fixes, 2 m of noise")
    low, high = way.min(0), way.max(0)
    middle, half = (low + high) / 2, max((high - low)[0] / 2 + 15, ((high - low)[1] / 2 + 15) * 10 / 6)
    axes.set(xlim=(middle[0] - half, middle[0] + half), ylim=(middle[1] - half * 0.6, middle[1] + half * 0.6), xlabel="east, m", ylabel="north, m")
    axes.set_aspect("equal")
    axes.legend(loc="upper right")
    figure.tight_layout()
    save(figure, path)


def main():
    endless, folder = sys.argv[1], pathlib.Path(sys.argv[2])
    with tempfile.TemporaryDirectory() as work:
        out = pathlib.Path(sys.argv[3]) if len(sys.argv) > 3 else pathlib.Path(work) / "out"
        video = next((out / "videos").iterdir()) if (out / "videos").exists() else drive(endless, out)
        radar(video, folder / "radar.jpg")
        events(video, folder / "event_camera.jpg")
        imu(video, folder / "imu.jpg")
        gnss(endless, video, folder / "gnss.jpg")


if __name__ == "__main__":
    main()
