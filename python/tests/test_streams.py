"""Reading and writing: every payload, every damage, and objects that hold all that messages hold."""
import dataclasses
import os
import random
import unittest

import numpy as np

import filum
import parts
from filum import data, framing


class Streams(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.folder = parts.Folder()
        cls.room = cls.folder.__enter__()
        cls.streams = parts.streams(cls.room)

    @classmethod
    def tearDownClass(cls):
        cls.folder.__exit__()

    def test_what_is_read_is_written_again_byte_for_byte(self):
        for name, stream in self.streams.items():
            with self.subTest(name):
                self.assertEqual(stream.payload.name.lower(), name)
                path = os.path.join(self.room, name)
                stream.write(path)
                with open(path, "rb") as f:
                    whole = f.read()
                self.assertEqual(filum.read(path).bytes(), whole)
                self.assertGreater(len(stream), 0)

    def test_programs_read_what_is_written(self):
        regions = self.streams["regions"]
        self.assertEqual(filum.Stream("regions", regions.frames, regions.history).fill().run().bytes(),
                         self.streams["paths"].bytes())

    def test_objects_have_exactly_the_fields_of_messages(self):
        for name, c in data.CLASSES.items():
            with self.subTest(name):
                self.assertEqual([f.name for f in dataclasses.fields(c)], [f.name for f in c.message.DESCRIPTOR.fields])
                for f in dataclasses.fields(c):
                    self.assertRegex(c.__doc__, rf"\b{f.name}\b", f"{name}.{f.name} is not explained")

    def test_a_stream_cut_anywhere_is_truncated(self):
        whole = self.streams["paths"].bytes()
        for at in sorted({0, 1, 14, 15, 16, len(whole) - 1} | set(random.Random(1).sample(range(len(whole)), 40))):
            with self.subTest(at), self.assertRaises(filum.Truncated):
                filum.read(whole[:at])

    def test_a_flipped_byte_is_found(self):
        whole = self.streams["paths"].bytes()
        for at in random.Random(2).sample(range(len(whole)), 60):
            damaged = bytearray(whole)
            damaged[at] ^= 255
            with self.subTest(at), self.assertRaises((filum.InputError, filum.Truncated)):
                filum.read(bytes(damaged))
        with self.assertRaises(filum.InputError):
            filum.read(whole + b"x")
        with self.assertRaises(filum.FileError):
            filum.read(os.path.join(self.room, "none"))

    def test_checksum_of_any_length_and_division(self):
        self.assertEqual(framing.crc32c(0, b"123456789"), 0xE3069283)  # the check value of CRC-32C
        rng = random.Random(3)
        for size in (0, 1, 65535, 131071, 131072, 300001):
            block = rng.randbytes(size)
            bytewise = 0
            for at in range(0, size, 1000):
                bytewise = framing.crc32c(bytewise, block[at:at + 1000])
            self.assertEqual(framing.crc32c(0, block), bytewise)
            cut = rng.randint(0, size)
            self.assertEqual(framing.crc32c(framing.crc32c(0, block[:cut]), block[cut:]), bytewise)

    def test_arrays_say_what_metrics_says(self):
        path = self.streams["toolpath"]
        figures = path.figures()
        self.assertEqual((figures["report"], figures["version"], figures["strokes"]), ("metrics", 1, 1))
        table = path.table()
        self.assertEqual(len(table), sum(len(s.x) for s in path))
        self.assertEqual(len(path.strokes()), 1)
        laid = sum(s.length for s in path if s.extrudes)
        volume = sum(s.volume for s in path)
        self.assertAlmostEqual(laid, figures["extruded_mm"], delta=0.06)
        self.assertAlmostEqual(volume, figures["volume_mm3"], delta=0.006)
        self.assertTrue(np.all(table["z"] > 0))

    def test_geometry_of_what_is_read(self):
        layer, region = self.streams["layers"][0], self.streams["regions"][0]
        self.assertAlmostEqual(layer.contours.area, 81)
        self.assertAlmostEqual(region.loops.area, region.area)
        loops = filum.Loops.of([[(0, 0), (4, 0), (4, 4), (0, 4)], [(1, 1), (1, 2), (2, 2), (2, 1)]])
        self.assertEqual((len(loops), loops.area, loops[-1].shape), (2, 15, (4, 2)))
        surface = self.streams["surface"][0]
        self.assertAlmostEqual(surface.area, 81 + 4 * 9 * 0.5, places=6)
        self.assertAlmostEqual(float(np.nanmin(surface.field("distance"))), 0, places=6)
        with self.assertRaises(KeyError):
            surface.field("stress")

    def test_a_payload_in_the_wrong_stream_is_refused(self):
        with self.assertRaises(filum.InputError):
            filum.Stream("paths", self.streams["layers"].frames).bytes()
        with self.assertRaises(filum.InputError):
            self.streams["paths"].table()

    def test_a_file_appears_whole_or_not_at_all(self):
        path = os.path.join(self.room, "wrong")
        with self.assertRaises(filum.InputError):
            filum.Stream("paths", self.streams["layers"].frames).write(path)
        self.assertFalse(os.path.exists(path))
        self.assertFalse([n for n in os.listdir(self.room) if n.startswith(".filum-")])


if __name__ == "__main__":
    unittest.main()
