// A proxy as docs/viewer.md has nginx: the page stands below /world/, its host name is kept, and
// who it is for is said.

import { createServer, request } from 'node:http';

const kPrefix = '/world/';

/** Serves what listens at that port of this machine; its address, and `close`. */
export async function startPrefixProxy(port) {
  const asked = [];
  const upgraded = new Set();  // sockets that the server below no longer counts among its own
  const forward = (incoming) => request({
    host: '127.0.0.1', port, method: incoming.method, path: incoming.url.slice(kPrefix.length - 1),
    headers: { ...incoming.headers, 'x-forwarded-for': incoming.socket.remoteAddress },
  });
  const proxy = createServer((incoming, outgoing) => {
    asked.push(incoming.url);
    if (!incoming.url.startsWith(kPrefix)) {
      outgoing.writeHead(404).end();
      return;
    }
    const onward = forward(incoming);
    onward.on('response', (answer) => {
      outgoing.writeHead(answer.statusCode, answer.headers);
      answer.pipe(outgoing);
    });
    onward.on('error', () => outgoing.destroy());
    incoming.pipe(onward);
  });
  proxy.on('upgrade', (incoming, socket, head) => {
    asked.push(incoming.url);
    upgraded.add(socket);
    socket.on('close', () => upgraded.delete(socket));
    for (const event of ['end', 'error']) socket.on(event, () => socket.destroy());
    if (!incoming.url.startsWith(kPrefix)) {
      socket.destroy();
      return;
    }
    const onward = forward(incoming);
    onward.on('upgrade', (answer, other, first) => {
      const lines = answer.rawHeaders.flatMap((name, i, all) => (i % 2 === 0 ? [`${name}: ${all[i + 1]}`] : []));
      socket.write(['HTTP/1.1 101 Switching Protocols', ...lines, '', ''].join('\r\n'));
      other.on('error', () => socket.destroy());
      socket.on('close', () => other.destroy());
      other.on('close', () => socket.destroy());
      if (first.length > 0) socket.write(first);
      if (head.length > 0) other.write(head);
      socket.pipe(other).pipe(socket);
    });
    for (const event of ['response', 'error']) onward.on(event, () => socket.destroy());
    onward.end();
  });
  await new Promise((resolve, reject) => {
    proxy.on('error', reject);
    proxy.listen(0, '127.0.0.1', resolve);
  });
  return {
    address: `http://127.0.0.1:${proxy.address().port}${kPrefix}`,
    /** Paths that were asked for, in order. */
    asked,
    close: () => new Promise((resolve) => {
      proxy.close(resolve);
      proxy.closeAllConnections();
      for (const socket of upgraded) socket.destroy();
    }),
  };
}
