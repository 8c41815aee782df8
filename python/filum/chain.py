"""Stages as methods: what Stream and Pipeline share."""
from . import programs


class Chain:
    """Every program of `filum list` is a method that appends it: `x.fill(pattern="zigzag", bead_width=0.5)`.

    Options are keyword arguments, with _ for -: True for a flag, lists for several values, a Stream or Pipeline where a
    file is asked for.  help(x.fill) is the stage's own.  The work begins with run(), save(), gcode(), figures() or
    where the result is iterated over."""

    def __getattr__(self, name):
        if name.startswith("_") or not programs.is_stage(name):
            raise AttributeError(f"'{type(self).__name__}' has no attribute or stage '{name}'")
        return programs.named(lambda *words, **options: self.stage(name, *words, **options), name)

    def __dir__(self):
        return sorted(set(super().__dir__()) | set(programs.stages()))

    def stage(self, name, *words, **options):
        """This, then the program `name` (as the method of that name)."""
        from .pipeline import Pipeline
        return Pipeline.after(self, name, words, options)

    def apply(self, own, **options):
        """This, then a stage of one's own: what filum.stage made, or a function from an item to items."""
        from .pipeline import Pipeline
        return Pipeline.after(self, own, (), options)

    def gcode(self, machine="marlin", **options):
        """The machine's program as text: `postproc --machine ...`."""
        return self.stage("postproc", machine=machine, **options).run()

    def figures(self, **options):
        """The figures of `metrics` as a dict: docs/metrics.md says what each key means.  figures(regions=...) measures
        coverage, too; figures(surface=...) is of paths on a surface."""
        import json
        return json.loads(self.stage("metrics", format="json", **options).run())

    def picture(self, **options):
        """A PNG picture as bytes, of `render`; a notebook shows it where the last line is `IPython.display.Image(...)`."""
        return self.stage("render", **options).run()
