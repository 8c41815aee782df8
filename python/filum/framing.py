"""The frames of a stream: docs/stream.md, and no more.  Bytes to protobuf messages and back."""
import io

import numpy as np
from google.protobuf.message import DecodeError

from . import stream_pb2
from .errors import InputError, Truncated

PREAMBLE = b"\x0e\x09\x00\x89Filum\x0a\x15\x01\x00\x00\x00"
MAX_FRAME = 64 << 20  # bytes
_POLYNOMIAL = 0x82F63B78  # CRC-32C, bits reversed
_LANES = 4096  # that are summed side by side


def _table():
    out = np.arange(256, dtype=np.uint32)
    for _ in range(8):
        out = np.where(out & 1, (out >> 1) ^ np.uint32(_POLYNOMIAL), out >> 1).astype(np.uint32)
    return out


_TABLE = _table()
_PAIRS = _TABLE[np.arange(65536) & 255] ^ (np.arange(65536, dtype=np.uint32) >> np.uint32(8))
_PAIRS = (_TABLE[_PAIRS & 255] ^ (_PAIRS >> np.uint32(8))).astype(np.uint32)  # two bytes at once
_PLAIN = [int(v) for v in _TABLE]


def _after_zeros(columns, count):
    """What `count` zero bytes make of a register, as the images of its 32 bits; `columns`: of one byte."""
    out = np.uint32(1) << np.arange(32, dtype=np.uint32)
    while count:
        if count & 1:
            out = _applied(columns, out)
        columns = _applied(columns, columns)
        count >>= 1
    return out


def _applied(columns, registers):
    out = np.zeros_like(registers)
    for bit in range(32):
        out ^= np.where(registers >> np.uint32(bit) & np.uint32(1), columns[bit], np.uint32(0))
    return out


def _one_zero():
    bits = np.uint32(1) << np.arange(32, dtype=np.uint32)
    return _TABLE[bits & 255] ^ (bits >> np.uint32(8))


def crc32c(crc, data):
    """The CRC-32C of the bytes so far, carried on over `data`; begin with 0.

    Long data is cut into lanes that are summed side by side; a sum is linear, so lanes are put together by what the
    bytes behind them would do to it (zeros)."""
    register = crc ^ 0xFFFFFFFF
    length = len(data) // _LANES // 2 * 2
    if length >= 16:
        lanes = np.frombuffer(data, "<u2", length * _LANES // 2).reshape(_LANES, length // 2).T.copy()
        sums = np.zeros(_LANES, np.uint32)
        sums[0] = register
        for column in lanes:
            sums = _PAIRS.take(sums.astype(np.uint16) ^ column) ^ (sums >> np.uint32(16))
        skip, width = _after_zeros(_one_zero(), length), _LANES
        while width > 1:
            sums = _applied(skip, sums[0::2]) ^ sums[1::2]
            skip = _applied(skip, skip)
            width //= 2
        register = int(sums[0])
        data = data[length * _LANES:]
    for byte in bytes(data):
        register = _PLAIN[(register ^ byte) & 255] ^ (register >> 8)
    return register ^ 0xFFFFFFFF


def varint(value):
    out = bytearray()
    while value > 127:
        out.append(value & 127 | 128)
        value >>= 7
    out.append(value)
    return bytes(out)


class Reader:
    """Checks the preamble and reads `header`; frames() gives the rest and checks the end frame."""

    def __init__(self, file, payload=None):
        """file: binary, open; payload: a number of stream_pb2.Payload, the only one allowed."""
        self._file, self._crc, self._count = file, 0, 0
        head = file.read(len(PREAMBLE))
        if head != PREAMBLE:
            if PREAMBLE.startswith(head):
                raise Truncated("it ends before its header; the stage before did not finish")
            raise InputError("it is no Filum stream of version 1")
        self._crc = crc32c(0, head)
        kind, self.header = self._frame()
        if kind != "header":
            raise InputError("its first frame is no header")
        if payload is not None and self.header.payload != payload:
            name = stream_pb2.Payload.Name
            raise InputError(f"it carries {name(self.header.payload)}, not {name(payload)}")

    def _frame(self):
        prefix, length, shift = b"", 0, 0
        while not prefix or prefix[-1] & 128:
            byte = self._file.read(1)
            if not byte:
                raise Truncated("it ends before its end frame; the stage before did not finish")
            prefix += byte
            length |= (byte[0] & 127) << shift
            shift += 7
            if length > MAX_FRAME or shift > 63:
                raise InputError("a frame is longer than 64 MiB")
        body = self._file.read(length)
        if len(body) < length:
            raise Truncated("it ends inside a frame; the stage before did not finish")
        frame = stream_pb2.Frame()
        try:
            frame.ParseFromString(body)
        except (DecodeError, RuntimeError) as cause:
            raise InputError("a frame is malformed") from cause
        kind = frame.WhichOneof("frame")
        if kind is None:
            raise InputError("it holds a frame of an unknown kind")
        if kind != "end":
            self._crc = crc32c(crc32c(self._crc, prefix), body)
            self._count += 1
        return kind, getattr(frame, kind)

    def frames(self):
        """(kind, message) of every frame between header and end; kind: "layer", "note" and so on."""
        payload = stream_pb2.Payload.Name(self.header.payload)
        while True:
            kind, message = self._frame()
            if kind in ("note", "fact") or kind == FRAMES.get(payload):
                yield kind, message
                continue
            if kind != "end":
                raise InputError(f"it holds a {kind} frame among {payload}")
            if message.frames != self._count or message.crc32c != self._crc:
                raise InputError("its checksum is wrong; it was damaged on the way")
            if self._file.read(1):
                raise InputError("something follows its end frame")
            return


FRAMES = {"LAYERS": "layer", "REGIONS": "region", "PATHS": "paths", "TOOLPATH": "span", "SURFACE": "surface"}


class Writer:
    """Writes preamble and header; nothing counts until close() has written the end frame."""

    def __init__(self, file, header):
        self._file, self._crc, self._count = file, 0, 0
        self._put(PREAMBLE)
        self.write("header", header)

    def _put(self, data):
        self._crc = crc32c(self._crc, data)
        self._file.write(data)

    def write(self, kind, message):
        body = stream_pb2.Frame(**{kind: message}).SerializeToString(deterministic=True)
        if len(body) > MAX_FRAME:
            raise InputError(f"a {kind} frame would be longer than 64 MiB")
        self._put(varint(len(body)) + body)
        self._count += 1

    def close(self):
        """Writes the end frame: only when all that was read was found right."""
        end = stream_pb2.End(frames=self._count, crc32c=self._crc)
        body = stream_pb2.Frame(end=end).SerializeToString()
        self._file.write(varint(len(body)) + body)
        self._file.flush()


def opened(source):
    """bytes, or anything with read(), as a binary file."""
    return io.BytesIO(source) if isinstance(source, (bytes, bytearray, memoryview)) else source
