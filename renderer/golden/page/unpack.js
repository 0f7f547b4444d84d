// Pictures as packed_picture.h writes them.
const unpack = (() => {
const planeBytes = { u8: 1, u16: 2, f16: 2, f32: 4 };

async function inflate(text) {
  const packed = Uint8Array.from(atob(text), (c) => c.charCodeAt(0));
  const stream = new Blob([packed]).stream().pipeThrough(new DecompressionStream('deflate'));
  return new Uint8Array(await new Response(stream).arrayBuffer());
}

function half(bits) {
  const sign = bits & 0x8000 ? -1 : 1, exponent = bits >> 10 & 31, fraction = bits & 1023;
  if (exponent === 31) return fraction ? NaN : sign * Infinity;
  return sign * (exponent ? 2 ** (exponent - 15) * (1 + fraction / 1024) : 2 ** -14 * fraction / 1024);
}

// What a picture's text holds: the head with values[channel][pixel] and the planes for the output that refers to them.
return async function (head, text, golden) {
  const bytes = await inflate(text), { width, height, type } = head, pixels = width * height;
  if (head.from === 'golden') {
    for (let i = 0; i < bytes.length; ++i) bytes[i] += golden.bytes[i];
  } else {
    for (let i = 1; i < bytes.length; ++i) bytes[i] += bytes[i % width ? i - 1 : i - width];
  }
  const size = planeBytes[type], word = new DataView(new ArrayBuffer(4));
  const values = head.channels.map((_, c) => {
    const list = new Float32Array(pixels), first = c * size * pixels;
    for (let p = 0; p < pixels; ++p) {
      let bits = 0;
      for (let b = 0; b < size; ++b) bits |= bytes[first + b * pixels + p] << 8 * b;
      if (type === 'f32') word.setInt32(0, bits);
      list[p] = type === 'u8' ? bits / 255 : type === 'u16' ? bits / 65535 : type === 'f16' ? half(bits) : word.getFloat32(0);
    }
    return list;
  });
  return { ...head, bytes, values };
};
})();
