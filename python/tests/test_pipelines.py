"""Running stages: results, files, errors with the stage's own words, stages of one's own."""
import contextlib
import io
import os
import subprocess
import sys
import unittest

import numpy as np

import filum
import parts


@filum.stage(reads="layers", writes="layers")
def mirrored(layer, about: filum.MM = 0.0):
    """turns layers left to right"""
    layer.contours = filum.Loops.of([[2 * about, 0] + loop[::-1] * [-1, 1] for loop in layer.contours])
    return layer


class Pipelines(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.folder = parts.Folder()
        cls.room = cls.folder.__enter__()
        cls.part = parts.box(os.path.join(cls.room, "box.off"))

    @classmethod
    def tearDownClass(cls):
        cls.folder.__exit__()

    def test_a_program_in_one_line(self):
        text = filum.slice(self.part).regions().sequence().fill(pattern="zigzag").link3d().gcode("marlin")
        self.assertGreater(text.count("\nG1 "), 20)
        path = os.path.join(self.room, "box.gcode")
        filum.slice(self.part).regions().sequence().fill(pattern="zigzag").link3d().postproc(machine="marlin").save(path)
        with open(path, encoding="ascii") as f:
            self.assertEqual(f.read(), text)

    def test_options_reach_the_stage(self):
        regions = filum.slice(self.part, layer_height=0.25).regions().sequence().run()
        self.assertEqual(len(regions), 4)
        path = regions.fill(pattern="zigzag", angles=[0, 45], bead_width=np.float64(0.5)).run()
        said = {s.name: s.value for s in path.history[-1].settings}
        self.assertEqual((said["angles"], said["bead-width"]), ("0,45", "0.5"))
        self.assertNotIn("coverage", path.link3d().figures())
        self.assertIn("coverage", path.link3d().figures(regions=regions))

    def test_a_picture(self):
        self.assertEqual(filum.slice(self.part).picture()[:8], b"\x89PNG\r\n\x1a\n")

    def test_errors_are_the_stages_own(self):
        chain = filum.slice(self.part).regions()
        for kind, code, words, run in (
                (filum.UsageError, 2, "unknown option '--foo=1'", lambda: chain.sequence(foo=1).run()),
                (filum.InputError, 3, "it carries Regions, not Paths", lambda: chain.link3d().run()),
                (filum.FileError, 5, "none.stl", lambda: filum.slice("none.stl").regions().run()),
                (filum.UsageError, 2, "nonesuch", lambda: filum.slice(self.part).regions().sequence().fill().link3d().gcode("nonesuch"))):
            with self.subTest(words), self.assertRaises(kind) as caught:
                run()
            self.assertIn(words, str(caught.exception))
            self.assertEqual(caught.exception.code, code)
        path = os.path.join(self.room, "none.layers")
        with self.assertRaises(filum.Error):
            filum.slice("none.stl").save(path)
        self.assertFalse(os.path.exists(path))

    def test_the_first_stage_that_fails_speaks(self):
        with self.assertRaises(filum.FileError) as caught:
            filum.slice("none.stl").regions().sequence().fill().run()
        self.assertEqual(caught.exception.stage, "slice")

    def test_what_stages_say_is_kept(self):
        hair = parts.box(os.path.join(self.room, "hair.off"), (9, 0.05, 1))
        chain = filum.slice(hair).regions().sequence().fill()
        with contextlib.redirect_stderr(io.StringIO()) as said:
            out = chain.run()
        self.assertEqual("".join(m + "\n" for m in chain.messages), said.getvalue())
        self.assertTrue(chain.messages and out.notes)

    def test_stages_have_help_and_names(self):
        self.assertIn("bead lines that fill each region", filum.fill.__doc__)
        self.assertIn("slice", dir(filum))
        self.assertIn("link3d", dir(filum.slice(self.part)))
        with self.assertRaises(AttributeError):
            filum.nonesuch
        with self.assertRaises(AttributeError):
            filum.slice(self.part).nonesuch

    def test_a_function_between_programs(self):
        layers = filum.slice(self.part).apply(mirrored, about=1).run()
        self.assertEqual([r.program for r in layers.history], ["slice", "mirrored"])
        x = layers[0].contours.x
        self.assertAlmostEqual(x.min(), -7)
        self.assertAlmostEqual(layers[0].contours.area, 81)
        regions = filum.slice(self.part).apply(mirrored).regions().run()
        self.assertAlmostEqual(regions[0].loops.x.max(), 0)
        with self.assertRaises(filum.UsageError):
            layers.apply(mirrored, over=1).run()
        with self.assertRaises(filum.InputError):
            layers.regions().apply(mirrored).run()

    def test_a_failing_function_names_item_and_line(self):
        with self.assertRaises(filum.WorkError) as caught:
            filum.slice(self.part).apply(lambda layer: 1 / 0).run()
        self.assertRegex(str(caught.exception), "Layer 0: ZeroDivisionError in line [0-9]+: division by zero")
        with self.assertRaises(filum.WorkError):
            filum.slice(self.part).apply(lambda layer: [3]).run()


class OwnPrograms(unittest.TestCase):
    """`mirrored` as a program: this file, run."""

    @classmethod
    def setUpClass(cls):
        cls.folder = parts.Folder()
        room = cls.folder.__enter__()
        cls.room = room
        cls.input = filum.slice(parts.box(os.path.join(room, "box.off"))).run().bytes()

    @classmethod
    def tearDownClass(cls):
        cls.folder.__exit__()

    def mirror(self, *words, given=None):
        return subprocess.run([sys.executable, __file__, "--as-program", *words], capture_output=True, check=False,
                              input=self.input if given is None else given)

    def test_it_does_what_the_function_does(self):
        done = self.mirror("--about=1")
        self.assertEqual((done.returncode, done.stderr), (0, b""))
        self.assertEqual(done.stdout, filum.read(self.input).apply(mirrored, about=1.0).run().bytes())
        path = os.path.join(self.room, "out")
        self.assertEqual(self.mirror("-o", path, "--about", "1").returncode, 0)
        with open(path, "rb") as f:
            self.assertEqual(f.read(), done.stdout)

    def test_it_refuses_as_the_others_do(self):
        for code, words, given in ((2, ["--nonesuch"], None), (2, ["--about"], None), (2, ["--about=x"], None),
                                   (2, ["--about=nan"], None), (2, ["a", "b"], None), (4, [], b""), (4, [], self.input[:-1]),
                                   (3, [], b"solid cube, and so on"), (3, [], self.input + b"x"), (5, ["none"], None),
                                   (5, ["-o", "none/there"], None),
                                   (3, [], filum.read(self.input).regions().run().bytes())):
            done = self.mirror(*words, given=given)
            said = done.stderr.decode()
            self.assertEqual(done.returncode, code, (words, said))
            self.assertRegex(said, r"\Amirrored: [^A-Z][^\n]*[^.]\n\Z")

    def test_it_speaks_for_itself(self):
        self.assertIn("--about MM", self.mirror("--help").stdout.decode())
        self.assertEqual(self.mirror("--version").stdout, b"mirrored 1\n")
        self.assertIn(b"in stream Layers\n", self.mirror("--print-contract").stdout)


if __name__ == "__main__":
    if "--as-program" in sys.argv:
        mirrored.main(sys.argv[2:])
    unittest.main()
