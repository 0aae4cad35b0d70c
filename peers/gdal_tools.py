"""GDAL's tools read an export --to geotiff, warp it to degrees and shade it."""
# debian: gdal-bin
# pypi: numpy==2.4.6

import json

from ground import Ground
from peer import FOLDER, Peer, export, run


def main():
    version = run("gdalinfo", "--version").stdout.split(",")[0].split()[-1]
    peer = Peer("GDAL's tools", version, "`--to geotiff`")
    folder = export("geotiff", "geotiff")
    ground = Ground(export("heights", "heights"))
    places = ground.places(1000, centers=True)
    given = "\n".join(f"{x} {y}" for x, y in places)
    said = run("gdallocationinfo", "-geoloc", "-valonly", folder / "elevation.tif", input=given)
    ground.check(peer, [float(line) for line in said.stdout.split()], places)
    warped = FOLDER / "degrees.tif"
    run("gdalwarp", "-q", "-t_srs", "EPSG:4326", "-r", "bilinear", folder / "elevation.tif", warped)
    about = json.loads(run("gdalinfo", "-json", warped).stdout)
    lon, lat = about["cornerCoordinates"]["center"]
    earth = ground.about["earth"]
    off_m = max(abs(lat - earth["latitude_deg"]), abs(lon - earth["longitude_deg"])) * 111e3
    peer.check("gdalwarp to EPSG:4326", off_m < 0.5, f"its middle is {off_m:.2f} m off")
    statistics = json.loads(run("gdalinfo", "-json", "-stats", warped).stdout)["bands"][0]
    peer.check("heights after it", abs(statistics["maximum"] - ground.about["highest"]) < 0.1,
               f"{statistics['minimum']:.2f} to {statistics['maximum']:.2f} m")
    for mode in ("hillshade", "slope", "roughness"):
        done = run("gdaldem", mode, "-q", folder / "elevation.tif", FOLDER / f"{mode}.tif")
        peer.check(f"gdaldem {mode}", done.returncode == 0 and not done.stdout.strip(),
                   done.stdout.strip() or "done")
    peer.finish()


main()
