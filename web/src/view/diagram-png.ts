/** Pixels for one unit of the drawing: sharp on a slide. */
const PIXELS = 2;

/** The drawing as a picture of twice its size. */
export async function pngOf(svg: string): Promise<Blob> {
  const address = URL.createObjectURL(new Blob([svg], { type: 'image/svg+xml' }));
  try {
    const image = new Image();
    image.src = address;
    await image.decode();
    const canvas = document.createElement('canvas');
    canvas.width = image.naturalWidth * PIXELS;
    canvas.height = image.naturalHeight * PIXELS;
    const context = canvas.getContext('2d');
    if (!context) throw new Error('This browser draws no pictures; save the diagram as SVG.');
    context.drawImage(image, 0, 0, canvas.width, canvas.height);
    return await new Promise((resolve, reject) => {
      canvas.toBlob((blob) => {
        if (blob) resolve(blob);
        else reject(new Error('This browser writes no PNG; save the diagram as SVG.'));
      }, 'image/png');
    });
  } finally {
    URL.revokeObjectURL(address);
  }
}
