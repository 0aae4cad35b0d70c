// The WebSocket to the server: requests with replies, and a new attempt whenever it is lost.

const kFirstWait_ms = 500;
const kLongestWait_ms = 10000;

/** A request that failed; `code` as the server names it. */
export class RequestError extends Error {
  constructor(code, message) {
    super(message);
    this.code = code;
  }
}

/** How long to wait before attempt number `attempt` (0 the first), within a tenth of it at random. */
export function backoff_ms(attempt, random = Math.random) {
  const wait_ms = Math.min(kFirstWait_ms * 2 ** attempt, kLongestWait_ms);
  return wait_ms * (0.9 + 0.2 * random());
}

/**
 * Events: 'state' {state: 'connecting'|'open'|'lost', retry_ms}, 'json' (a message of the server),
 * 'binary' (ArrayBuffer).
 */
export class Connection extends EventTarget {
  #url;
  #socket = null;
  #attempt = 0;
  #timer = null;
  #pending = new Map();  // id -> {resolve, reject}
  #nextId = 1;

  constructor(url) {
    super();
    this.#url = url;
    this.state = 'connecting';
  }

  open() {
    clearTimeout(this.#timer);
    this.#setState('connecting');
    const socket = new WebSocket(this.#url);
    socket.binaryType = 'arraybuffer';
    this.#socket = socket;
    socket.onopen = () => {
      this.#attempt = 0;
      this.#setState('open');
    };
    socket.onmessage = ({ data }) => this.#receive(data);
    socket.onclose = () => this.#lost();
  }

  /** Sends a message that needs no reply; false where there is no connection. */
  send(message) {
    if (this.#socket?.readyState !== WebSocket.OPEN) return false;
    this.#socket.send(JSON.stringify(message));
    return true;
  }

  /** Sends a request; resolves with the server's reply, rejects with a RequestError. */
  request(message) {
    const id = this.#nextId++;
    return new Promise((resolve, reject) => {
      if (!this.send({ ...message, id })) {
        reject(new RequestError('UNAVAILABLE', 'There is no connection to the server.'));
        return;
      }
      this.#pending.set(id, { resolve, reject });
    });
  }

  #receive(data) {
    if (typeof data !== 'string') {
      this.dispatchEvent(new CustomEvent('binary', { detail: data }));
      return;
    }
    const message = JSON.parse(data);
    if (message.type === 'reply' && this.#pending.has(message.id)) {
      const { resolve, reject } = this.#pending.get(message.id);
      this.#pending.delete(message.id);
      if (message.ok) resolve(message);
      else reject(new RequestError(message.code, message.message));
      return;
    }
    this.dispatchEvent(new CustomEvent('json', { detail: message }));
  }

  #lost() {
    for (const { reject } of this.#pending.values()) {
      reject(new RequestError('UNAVAILABLE', 'The connection to the server was lost.'));
    }
    this.#pending.clear();
    const retry_ms = backoff_ms(this.#attempt++);
    this.#setState('lost', retry_ms);
    this.#timer = setTimeout(() => this.open(), retry_ms);
  }

  #setState(state, retry_ms = 0) {
    this.state = state;
    this.dispatchEvent(new CustomEvent('state', { detail: { state, retry_ms } }));
  }
}
