/** What a board can show besides its points, as readers meet it. */
export const LAYER_NAMES = {
  complex: 'Complex',
  cells: 'Voronoi cells',
  pairs: 'Cells of order two',
  delaunay: 'Delaunay edges',
  lists: 'Nearest landmarks',
  cover: 'Discs of radius ε',
  names: 'Names',
} as const;

export type Layer = keyof typeof LAYER_NAMES;
export const LAYERS = Object.keys(LAYER_NAMES) as readonly Layer[];

/** Words of an attribute: "complex names", with any separator that an address allows. */
export const wordsOf = (text: string): string[] => text.split(/[\s,_]+/).filter((word) => word !== '');

export const layersIn = (text: string): Layer[] => {
  const words = wordsOf(text);
  return LAYERS.filter((layer) => words.includes(layer));
};
