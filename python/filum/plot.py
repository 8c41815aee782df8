"""Pictures by matplotlib: layers, strokes, surfaces.  Each takes and returns an axes; lengths in mm.

`filum render` draws finer pictures faster; these are for looking into streams, and for adding one's own."""
import numpy as np

from .data import Payload, Role
from .errors import UsageError


def _pyplot():
    try:
        import matplotlib.pyplot as plt
    except ImportError as why:
        raise UsageError("plots need matplotlib; install the package python3-matplotlib") from why
    return plt


def _plain(axes, what):
    if axes is None:
        axes = _pyplot().figure(figsize=(7, 7)).add_subplot()
        axes.set_title(what)
    axes.set_aspect("equal")
    axes.set_xlabel("x [mm]")
    axes.set_ylabel("y [mm]")
    return axes


def _solid(axes, what):
    if axes is None:
        axes = _pyplot().figure(figsize=(8, 7)).add_subplot(projection="3d")
        axes.set_title(what)
    axes.set_xlabel("x [mm]")
    axes.set_ylabel("y [mm]")
    axes.set_zlabel("z [mm]")
    return axes


def colour(k):
    """A colour that differs from its neighbours': of stroke or region k."""
    return _pyplot().get_cmap("tab20")(int(k) % 20)


def quads(points, widths, closed=False):
    """Beads as seen from above: (n, 4, 2), a rectangle for every piece of a line (points n x 2, widths n)."""
    if closed:
        points, widths = np.vstack((points, points[:1])), np.append(widths, widths[0])
    a, b = points[:-1], points[1:]
    step = b - a
    length = np.hypot(step[:, 0], step[:, 1])
    keep = length > 0
    a, b, step, length = a[keep], b[keep], step[keep], length[keep]
    side = np.column_stack((-step[:, 1], step[:, 0])) / (2 * length[:, None])
    wa, wb = widths[:-1][keep, None] * side, widths[1:][keep, None] * side
    return np.stack((a + wa, b + wb, b - wb, a - wa), axis=1)


def _outlines(axes, loops, **look):
    from matplotlib.patches import PathPatch
    from matplotlib.path import Path
    parts = [np.vstack((loop, loop[:1])) for loop in loops if len(loop)]
    if parts:
        codes = [c for p in parts for c in [Path.MOVETO] + [Path.LINETO] * (len(p) - 2) + [Path.CLOSEPOLY]]
        axes.add_patch(PathPatch(Path(np.vstack(parts), codes), **look))


def _beads(axes, shapes, look):
    from matplotlib.collections import PolyCollection
    if len(shapes):
        axes.add_collection(PolyCollection(np.concatenate(shapes), facecolor=look, edgecolor=look, linewidth=0.1))


def layer(stream, number=0, axes=None):
    """One layer from above: contours, regions, curves or beads in their true widths; colours tell regions, of a
    toolpath strokes.  Travels are thin lines."""
    items = [i for i in stream if (i.index if stream.payload == Payload.LAYERS else i.layer) == number]
    if stream.payload == Payload.SURFACE or not items:
        raise UsageError(f"cannot draw layer {number}: the stream holds no such layer")
    axes = _plain(axes, f"layer {number}, {len(items)} {'spans' if stream.payload == Payload.TOOLPATH else 'parts'}")
    for item in items:
        if stream.payload == Payload.LAYERS:
            _outlines(axes, item.contours, facecolor="0.85", edgecolor="0.3", linewidth=0.6)
        elif stream.payload == Payload.REGIONS:
            _outlines(axes, item.loops, facecolor=colour(item.id), edgecolor="0.3", linewidth=0.6, alpha=0.6)
        elif stream.payload == Payload.PATHS:
            _beads(axes, [quads(c.points, c.widths, c.closed) for c in item.curves if len(c.x) > 1], colour(item.region))
        elif item.role == Role.TRAVEL:
            axes.plot(item.x, item.y, color="0.5", linewidth=0.5, linestyle=":")
        elif len(item.x) > 1:
            _beads(axes, [quads(item.points[:, :2], item.widths)], colour(item.stroke))
    axes.autoscale_view()
    return axes


def strokes(toolpath, axes=None, travels=True, linewidth=0.6):
    """A whole toolpath in space, a colour for each stroke; travels dotted."""
    if toolpath.payload != Payload.TOOLPATH:
        raise UsageError(f"cannot draw the strokes of {toolpath.payload.name}; a toolpath is needed")
    axes = _solid(axes, "strokes, a colour for each")
    for s in toolpath:
        if s.role != Role.TRAVEL:
            axes.plot(*s.points.T, color=colour(s.stroke), linewidth=linewidth)
        elif travels:
            axes.plot(*s.points.T, color="0.5", linewidth=0.5, linestyle=":")
    axes.set_aspect("equal")
    return axes


def surface(stream, field=None, toolpath=None, axes=None):
    """A surface, coloured by the field of that name (what is not known grey; of vectors their length), and a path on it."""
    if stream.payload != Payload.SURFACE:
        raise UsageError(f"cannot draw {stream.payload.name} as a surface")
    axes = _solid(axes, field or "surface")
    from matplotlib.cm import ScalarMappable
    from matplotlib.colors import Normalize
    known = np.concatenate([_values(s, field) for s in stream]) if field else np.zeros(0)
    known = known[np.isfinite(known)]
    scale = ScalarMappable(Normalize(known.min(), known.max()) if len(known) else None, "viridis")
    for s in stream:
        drawn = axes.plot_trisurf(*s.points.T, triangles=s.triangles, color="0.85", linewidth=0, shade=not field)
        if field:
            with np.errstate(invalid="ignore"):
                of = _values(s, field)[s.triangles].mean(axis=1)
            faces = scale.to_rgba(np.where(np.isfinite(of), of, 0))
            faces[~np.isfinite(of)] = (0.8, 0.8, 0.8, 1)
            drawn.set_facecolor(faces)
    if len(known):
        axes.figure.colorbar(scale, ax=axes, shrink=0.6, label=field)
    if toolpath is not None:
        strokes(toolpath, axes=axes)
    axes.set_aspect("equal")
    return axes


def _values(s, field):
    values = s.field(field)
    return np.linalg.norm(values, axis=1) if values.ndim > 1 else values
