/** Elements, icons and buttons are made as on the page. */
export { icon, iconButton, make } from '../app/make.ts';
