// Where the server's paths are, seen from the page: beside the page, which may stand below a proxy's prefix.

/** Address of a path of the server ("/api/world.json"). page: address of the page. */
export function addressOf(path, page = document.baseURI) {
  return new URL(path.replace(/^\/+/, ''), page).href;
}

/** Address of the WebSocket. */
export function socketAddress(page = document.baseURI) {
  const address = new URL('ws', page);
  address.protocol = address.protocol === 'https:' ? 'wss:' : 'ws:';
  return address.href;
}
