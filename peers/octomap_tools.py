"""octomap's own tools read an export --to octomap."""
# debian: octomap-tools

from peer import FOLDER, Peer, export, run


def main():
    version = run("dpkg-query", "-W", "-f", "${Version}", "octomap-tools").stdout
    peer = Peer("octomap-tools", version, "`--to octomap`")
    path = export("octomap", "world.bt")
    tree = FOLDER / "world.ot"
    done = run("convert_octree", path, tree)
    peer.check("convert_octree to .ot", done.returncode == 0 and tree.exists(),
               f"{path.stat().st_size} bytes to {tree.stat().st_size}")
    back = FOLDER / "back.bt"
    run("convert_octree", tree, back)
    same = back.exists() and back.read_bytes().split(b"data\n", 1)[1] == \
        path.read_bytes().split(b"data\n", 1)[1]
    peer.check("back to .bt", same, "the same bytes" if same else "other bytes")
    peer.finish()


main()
