"""Filum streams in Python: what docs/stream.md says, and no more.

Needs Debian's python3-protobuf, and the messages as Python:
    protoc --python_out=DIR -I proto filum/stream.proto filum/planar.proto filum/surface.proto
"""
import os
import struct
import sys

from filum import stream_pb2

PREAMBLE = b"\x0e\x09\x00\x89Filum\x0a\x15\x01\x00\x00\x00"
MAX_FRAME = 64 << 20


class Malformed(Exception):
    """Bad input: exit code 3."""


class Truncated(Exception):
    """The input ends before its end frame: exit code 4."""


def _make_tables():
    """Tables for eight bytes a step ("slicing by 8"): what a byte does to the sum k bytes later."""
    tables = [[0] * 256 for _ in range(8)]
    for i in range(256):
        c = i
        for _ in range(8):
            c = 0x82F63B78 ^ (c >> 1) if c & 1 else c >> 1
        tables[0][i] = c
    for k in range(1, 8):
        for i in range(256):
            before = tables[k - 1][i]
            tables[k][i] = tables[0][before & 255] ^ (before >> 8)
    return tables


_TABLES = _make_tables()


def crc32c(crc, data):
    """The CRC-32C of the bytes so far, carried on over `data`; start with 0."""
    t0, t1, t2, t3, t4, t5, t6, t7 = _TABLES
    crc ^= 0xFFFFFFFF
    whole = len(data) // 8 * 8
    for low, high in struct.iter_unpack("<II", data[:whole]):
        low ^= crc
        crc = (t7[low & 255] ^ t6[low >> 8 & 255] ^ t5[low >> 16 & 255] ^ t4[low >> 24]
               ^ t3[high & 255] ^ t2[high >> 8 & 255] ^ t1[high >> 16 & 255] ^ t0[high >> 24])
    for byte in data[whole:]:
        crc = t0[(crc ^ byte) & 255] ^ (crc >> 8)
    return crc ^ 0xFFFFFFFF


def varint(value):
    out = bytearray()
    while value > 127:
        out.append(value & 127 | 128)
        value >>= 7
    out.append(value)
    return bytes(out)


class Reader:
    """Checks the preamble, reads the header; frames() gives the rest and checks the end frame."""

    def __init__(self, file, payload):
        self._file, self._crc, self._count = file, 0, 0
        head = file.read(len(PREAMBLE))
        if head != PREAMBLE:
            raise (Truncated if PREAMBLE.startswith(head) else Malformed)("it is no Filum stream of version 1")
        self._crc = crc32c(0, head)
        frame = self._frame()
        if frame.WhichOneof("frame") != "header":
            raise Malformed("its first frame is no header")
        self.header = frame.header
        if self.header.payload != payload:
            raise Malformed("it carries another payload")

    def _frame(self):
        prefix, length, shift = b"", 0, 0
        while not prefix or prefix[-1] & 128:
            byte = self._file.read(1)
            if not byte:
                raise Truncated("it ends before its end frame")
            prefix += byte
            length |= (byte[0] & 127) << shift
            shift += 7
            if length > MAX_FRAME or shift > 63:
                raise Malformed("a frame is longer than 64 MiB")
        body = self._file.read(length)
        if len(body) < length:
            raise Truncated("it ends inside a frame")
        frame = stream_pb2.Frame()
        try:
            frame.ParseFromString(body)
        except Exception as cause:
            raise Malformed("a frame is malformed") from cause
        if frame.WhichOneof("frame") != "end":
            self._crc = crc32c(crc32c(self._crc, prefix), body)
            self._count += 1
        return frame

    def frames(self):
        while True:
            frame = self._frame()
            kind = frame.WhichOneof("frame")
            if kind != "end":
                yield kind, frame
                continue
            if frame.end.frames != self._count or frame.end.crc32c != self._crc:
                raise Malformed("its checksum is wrong")
            if self._file.read(1):
                raise Malformed("something follows its end frame")
            return


class Writer:
    """Writes preamble and header; nothing counts until close() has written the end frame."""

    def __init__(self, file, header):
        self._file, self._crc, self._count = file, 0, 0
        self._put(PREAMBLE)
        self.write(header=header)

    def _put(self, data):
        self._crc = crc32c(self._crc, data)
        self._file.write(data)

    def write(self, **field):
        body = stream_pb2.Frame(**field).SerializeToString()
        self._put(varint(len(body)) + body)
        self._count += 1

    def close(self):
        end = stream_pb2.Frame(end=stream_pb2.End(frames=self._count, crc32c=self._crc)).SerializeToString()
        self._file.write(varint(len(end)) + end)
        self._file.flush()


def header_after(before, payload, program, version, settings):
    """The header of what `program` makes of a stream with the header `before`."""
    out = stream_pb2.Header(payload=payload, units="mm", expected=before.expected)
    out.history.extend(before.history)
    run = out.history.add(program=program, version=version)
    for name, (value, changed) in settings.items():
        run.settings.add(name=name, value=str(value), changed=changed)
    if before.history:
        run.parents.append(len(before.history) - 1)
    return out


def main(program, work):
    """Runs `work` with Filum's exit codes: 3 bad input, 4 truncated, 5 input or output failed."""
    try:
        work()
    except Malformed as why:
        code, text = 3, f"cannot read standard input: {why}"
    except Truncated as why:
        code, text = 4, f"cannot read standard input: {why}; the stage before did not finish"
    except BrokenPipeError:
        os.dup2(os.open(os.devnull, os.O_WRONLY), sys.stdout.fileno())  # nothing more to say
        return 0
    except OSError as why:
        code, text = 5, f"cannot write to standard output: {why.strerror}"
    else:
        return 0
    print(f"{program}: {text}", file=sys.stderr)
    return code
