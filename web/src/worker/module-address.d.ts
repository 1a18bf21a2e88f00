declare module 'plateau-module/wasm' {
  const address: string;
  export default address;
}
