"""Plots draw what the streams hold."""
import unittest

try:
    import matplotlib
    matplotlib.use("Agg")
except ImportError:
    matplotlib = None
import numpy as np

import filum
import parts


@unittest.skipIf(matplotlib is None, "no python3-matplotlib")
class Plots(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        with parts.Folder() as room:
            cls.streams = parts.streams(room)

    def tearDown(self):
        import matplotlib.pyplot as plt
        plt.close("all")

    def test_a_layer_of_every_planar_stream(self):
        for name in ("layers", "regions", "paths", "toolpath"):
            axes = filum.plot.layer(self.streams[name], 2)
            (x0, x1), (y0, y1) = axes.get_xlim(), axes.get_ylim()
            self.assertTrue(-2 < x0 < 0.3 and 8.7 < x1 < 11 and -2 < y0 < 0.3 and 8.7 < y1 < 11, (name, x0, x1, y0, y1))
            with self.assertRaises(filum.UsageError):
                filum.plot.layer(self.streams[name], 99)

    def test_beads_are_as_wide_as_they_are(self):
        quads = filum.plot.quads(np.array([[0, 0], [2, 0], [2, 0], [2, 3]]), np.array([0.4, 0.4, 0.4, 0.2]))
        self.assertEqual(quads.shape, (2, 4, 2))
        self.assertAlmostEqual(float(np.ptp(quads[0][:, 1])), 0.4)

    def test_strokes_and_surface(self):
        self.assertGreater(len(filum.plot.strokes(self.streams["toolpath"]).lines), 0)
        axes = filum.plot.surface(self.streams["surface"], "distance")
        self.assertEqual(len(axes.collections), 1)
        with self.assertRaises(KeyError):
            filum.plot.surface(self.streams["surface"], "stress")
        with self.assertRaises(filum.UsageError):
            filum.plot.strokes(self.streams["layers"])


if __name__ == "__main__":
    unittest.main()
