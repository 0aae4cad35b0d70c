#!/usr/bin/python3
"""A chat server that misbehaves on demand, for the tests of the chat client.

The first part of a request's path names what goes wrong: http://127.0.0.1:PORT/hang/v1 never
answers. Called as misbehaving_server.py FOLDER, it prints one line of JSON with its ports and the
certificates of its TLS ports, appends each request to FOLDER/requests.jsonl and, once the other side
has closed a request's connection, its path to FOLDER/closed.jsonl. It ends when its standard input
does, so that it never outlives the test that started it.
"""

import collections
import json
import pathlib
import socket
import ssl
import subprocess
import sys
import threading
import time

FOLDER = pathlib.Path(sys.argv[1])
WORDS = ["Hel", "lo, ", "w\u00f6", "rld"]
LOCK = threading.Lock()
SEEN = collections.Counter()  # requests by scenario
TLS_HANDSHAKE = b"\x16"  # with which TLS begins


def chunk(delta, finish_reason=None, **more):
    choice = {"index": 0, "delta": delta, "finish_reason": finish_reason}
    return {"object": "chat.completion.chunk", "model": "tiny", "choices": [choice], **more}


def event(value):
    return b"data: " + json.dumps(value, ensure_ascii=False).encode() + b"\n\n"


USAGE = {"prompt_tokens": 11, "completion_tokens": 4, "total_tokens": 15}
TOKENS = [event(chunk({"content": word})) for word in WORDS]
STREAM = (event(chunk({"role": "assistant", "content": ""})) + b"".join(TOKENS) +
          event(chunk({}, "stop")) +
          event({"choices": [], "model": "tiny", "usage": USAGE}) + b"data: [DONE]\n\n")
ANSWER = json.dumps({
    "object": "chat.completion", "model": "tiny", "usage": USAGE,
    "choices": [{"index": 0, "message": {"role": "assistant", "content": "".join(WORDS)},
                 "finish_reason": "stop"}]}).encode()


def head(status, content_type="application/json", *more):
    lines = [f"HTTP/1.1 {status} Whatever", "Date: Sun, 06 Nov 1994 08:49:37 GMT",
             "Connection: close", *more]
    if content_type:
        lines.append(f"Content-Type: {content_type}")
    return "\r\n".join(lines).encode() + b"\r\n\r\n"


STREAM_HEAD = head(200, "text/event-stream")


def whole(status, body, content_type="application/json", *more):
    if not isinstance(body, bytes):
        body = json.dumps(body).encode()
    return head(status, content_type, f"Content-Length: {len(body)}", *more) + body


LOADING = whole(503, {"error": {
    "message": "Loading model", "type": "unavailable_error", "code": 503}})


def hang(connection):
    """Says nothing more until the other side has had enough."""
    while connection.recv(4096):
        pass


def wait_until_closed(connection):
    try:
        hang(connection)
    except OSError:
        pass  # that is closed as well


def for_ever(connection, piece, pause_s=0.0):
    while True:
        connection.sendall(piece)
        time.sleep(pause_s)


def pieces(connection, data, size):
    for i in range(0, len(data), size):
        connection.sendall(data[i:i + size])


def first_then(count, first, then):
    return first if count == 1 else then


# Each takes the connection, how often it was asked before (from 1), and the request.
SCENARIOS = {
    "good": lambda c, n, r: c.sendall(STREAM_HEAD + STREAM),
    "byte_by_byte": lambda c, n, r: pieces(c, STREAM_HEAD + STREAM, 1),
    "not_a_stream": lambda c, n, r: c.sendall(whole(200, ANSWER)),
    "no_end_mark": lambda c, n, r: (
        c.sendall(STREAM_HEAD + STREAM[:STREAM.index(b"data: [DONE]")]), hang(c)),
    "thinks_aloud": lambda c, n, r: c.sendall(
        STREAM_HEAD + event(chunk({"reasoning_content": "hm, hm"})) + STREAM),
    # A form holds from the first letter on, so that the thinking of the model cannot end.
    "answers_in_thinking": lambda c, n, r: c.sendall(
        STREAM_HEAD + event(chunk({"content": ""})) +
        b"".join(event(chunk({"reasoning_content": part})) for part in ('{"rows"', ': ["A"]}')) +
        event(chunk({"content": "\n"})) + event(chunk({}, "stop")) + b"data: [DONE]\n\n"),
    "answers_matrix_in_thinking": lambda c, n, r: c.sendall(
        STREAM_HEAD + b"".join(event(chunk({"reasoning_content": row + ("\n" if i < 31 else "")}))
                               for i, row in enumerate(["WFWF" * 8] * 32)) +
        event(chunk({"content": "\n"})) + event(chunk({}, "stop")) + b"data: [DONE]\n\n"),
    "answers_in_thinking_whole": lambda c, n, r: c.sendall(whole(200, {"choices": [{
        "message": {"content": None, "reasoning": '{"rows": ["A"]}'}, "finish_reason": "stop"}]})),
    "only_thinks": lambda c, n, r: c.sendall(
        STREAM_HEAD + event(chunk({"reasoning_content": 'Hm: {"rows": ["A"]} or not?'})) +
        event(chunk({}, "stop")) + b"data: [DONE]\n\n"),
    "cut_in_thinking": lambda c, n, r: c.sendall(
        STREAM_HEAD + event(chunk({"reasoning_content": '{"rows": ["A"'})) +
        event(chunk({}, "length")) + b"data: [DONE]\n\n"),
    "length": lambda c, n, r: c.sendall(
        STREAM_HEAD + TOKENS[0] + event(chunk({}, "length")) + b"data: [DONE]\n\n"),
    "no_models": lambda c, n, r: c.sendall(whole(200, {"object": "list", "data": []})),
    # Faults of the connection.
    "hang": lambda c, n, r: hang(c),
    "tls_hello": lambda c, n, r: hang(c),  # TLS where none is spoken, whatever its path
    "hang_in_answer": lambda c, n, r: (c.sendall(STREAM_HEAD + TOKENS[0]), hang(c)),
    "hang_after_token": lambda c, n, r: (c.sendall(STREAM_HEAD + TOKENS[0]), hang(c)),
    "hang_in_head": lambda c, n, r: (c.sendall(b"HTTP/1.1 200 OK\r\nContent-"), hang(c)),
    "slow_drip": lambda c, n, r: (c.sendall(STREAM_HEAD), for_ever(c, TOKENS[0], 0.02)),
    "slow_comments": lambda c, n, r: (c.sendall(STREAM_HEAD), for_ever(c, b": wait\n\n", 0.02)),
    "disconnect_before": lambda c, n, r: None,
    "disconnect_in_stream": lambda c, n, r: c.sendall(
        head(200, "text/event-stream", "Transfer-Encoding: chunked") + b"%x\r\n" %
        len(TOKENS[0]) + TOKENS[0] + b"\r\n"),
    "disconnect_after_end": lambda c, n, r: c.sendall(
        head(200, "text/event-stream", "Transfer-Encoding: chunked") + b"ffff\r\n" +
        STREAM[:STREAM.index(b"data: [DONE]")]),
    "disconnect_once": lambda c, n, r: c.sendall(
        STREAM_HEAD + first_then(n, TOKENS[0] + TOKENS[1] + b"data: {\"cho", STREAM)),
    "half_json": lambda c, n, r: c.sendall(
        head(200, "application/json", f"Content-Length: {len(ANSWER)}") + ANSWER[:60]),
    "half_json_no_length": lambda c, n, r: c.sendall(head(200) + ANSWER[:60]),
    "bad_chunks": lambda c, n, r: c.sendall(
        head(200, "text/event-stream", "Transfer-Encoding: chunked") + b"zz\r\nwhat\r\n"),
    # Faults of what is said.
    "garbage": lambda c, n, r: c.sendall(bytes(range(128, 256)) * 4 + b"\r\n\r\n"),
    "no_status": lambda c, n, r: c.sendall(b"HTTP/200 \r\nContent-Type:\n\r\n a\n]}"),
    "garbage_body": lambda c, n, r: c.sendall(whole(200, bytes(range(1, 256)))),
    "garbage_event": lambda c, n, r: c.sendall(STREAM_HEAD + b"data: not JSON\n\n"),
    "bad_utf8": lambda c, n, r: c.sendall(
        STREAM_HEAD + b'data: {"choices":[{"delta":{"content":"\xff\xfe"}}]}\n\n'),
    "html": lambda c, n, r: c.sendall(
        whole(200, b"<html><title>Welcome</title></html>", "text/html")),
    "wrong_content_type": lambda c, n, r: c.sendall(head(200, "text/html") + STREAM),
    "no_content_type": lambda c, n, r: c.sendall(head(200, None) + STREAM),
    "other_json": lambda c, n, r: c.sendall(whole(200, {"status": "ok"})),
    "empty_body": lambda c, n, r: c.sendall(whole(200, b"")),
    "huge_json": lambda c, n, r: (c.sendall(head(200) + b'{"a":"'), for_ever(c, b"x" * 65536)),
    "huge_stream": lambda c, n, r: (c.sendall(STREAM_HEAD), for_ever(c, TOKENS[0] * 500)),
    "endless_line": lambda c, n, r: (c.sendall(STREAM_HEAD + b"data: "),
                                     for_ever(c, b"x" * 65536)),
    "header_flood": lambda c, n, r: (c.sendall(b"HTTP/1.1 200 OK\r\n"),
                                     for_ever(c, b"X-More: and more\r\n" * 100)),
    "endless_header": lambda c, n, r: (c.sendall(b"HTTP/1.1 200 OK\r\nX-More: "),
                                       for_ever(c, b"x" * 65536)),
    "error_in_stream": lambda c, n, r: c.sendall(
        STREAM_HEAD + TOKENS[0] +
        event({"error": {"message": "out of memory", "type": "server_error", "code": None}})),
    "overload_in_stream": lambda c, n, r: c.sendall(STREAM_HEAD + first_then(
        n, TOKENS[0] + event({"error": {"message": "busy", "code": 503}}), STREAM)),
    "error_in_200": lambda c, n, r: c.sendall(whole(200, {"error": "no such model"})),
    "refusal": lambda c, n, r: c.sendall(
        STREAM_HEAD + event(chunk({"refusal": "I will not draw that"})) +
        event(chunk({}, "stop")) + b"data: [DONE]\n\n"),
    "echoes_key_as_answer": lambda c, n, r: c.sendall(
        STREAM_HEAD + event(chunk({"content": r["headers"].get("authorization", "")}, "stop"))),
    # HTTP's own errors. Where a key came, it is thrown back, as some servers do.
    "401": lambda c, n, r: c.sendall(whole(401, {"error": {
        "message": "Incorrect API key provided: " + r["headers"].get("authorization", "none"),
        "type": "invalid_request_error", "param": None, "code": "invalid_api_key"}})),
    "401_hang": lambda c, n, r: (c.sendall(head(401) + b'{"error":"wrong key"'), hang(c)),
    "403": lambda c, n, r: c.sendall(whole(403, {"detail": "Not your model"})),
    "404": lambda c, n, r: c.sendall(whole(404, {
        "object": "error", "message": "The model `tiny` does not exist.",
        "type": "NotFoundError", "param": None, "code": 404})),
    "400": lambda c, n, r: c.sendall(whole(400, {"error": {
        "code": 400, "message": "Failed to parse grammar", "type": "invalid_request_error"}})),
    "422": lambda c, n, r: c.sendall(whole(422, {"detail": [
        {"loc": ["body", "messages", 0], "msg": "field required", "type": "missing"}]})),
    "429_then_good": lambda c, n, r: c.sendall(first_then(
        n, whole(429, {"message": "slow down"}, "application/json", "Retry-After: 0"),
        STREAM_HEAD + STREAM)),
    "429_date_then_good": lambda c, n, r: c.sendall(first_then(
        n, whole(429, {"message": "slow down"}, "application/json",
                 "Retry-After: Sun, 06 Nov 1994 08:49:37 GMT"), STREAM_HEAD + STREAM)),
    "429_for_a_second": lambda c, n, r: c.sendall(first_then(
        n, whole(429, {"message": "slow down"}, "application/json", "Retry-After: 1"),
        STREAM_HEAD + STREAM)),
    "429_too_long": lambda c, n, r: c.sendall(whole(
        429, {"message": "slow down"}, "application/json", "Retry-After: 3600")),
    "429_date_too_long": lambda c, n, r: c.sendall(whole(
        429, {"message": "slow down"}, "application/json",
        "Retry-After: Sun, 06 Nov 1994 09:49:37 GMT")),
    "429_quota": lambda c, n, r: c.sendall(whole(429, {"error": {
        "message": "You exceeded your current quota", "type": "insufficient_quota",
        "code": "insufficient_quota"}})),
    "500_empty": lambda c, n, r: c.sendall(whole(500, {"error": {"message": "", "code": None}})),
    "500_no_body": lambda c, n, r: c.sendall(whole(500, b"", None)),
    "500_huge": lambda c, n, r: (c.sendall(head(500, "text/plain")), for_ever(c, b"no " * 9999)),
    "500_beyond_limit": lambda c, n, r: c.sendall(whole(500, b"no " * 9999, "text/plain")),
    "502_html": lambda c, n, r: c.sendall(whole(
        502, b"<html><head><title>502 Bad Gateway</title></head></html>", "text/html")),
    "503_then_good": lambda c, n, r: c.sendall(STREAM_HEAD + STREAM if n > 2 else LOADING),
    "503": lambda c, n, r: c.sendall(LOADING),
    "503_in_time": lambda c, n, r: c.sendall(LOADING),
    "503_for_long": lambda c, n, r: c.sendall(LOADING),
    "504": lambda c, n, r: c.sendall(whole(504, b"upstream timed out", "text/plain")),
    "busy_then_good_then_401": lambda c, n, r: (
        SCENARIOS["401"](c, n, r) if n > 2 else
        c.sendall(first_then(n, LOADING, STREAM_HEAD + STREAM))),
    "redirect": lambda c, n, r: c.sendall(whole(
        307, b"", None, f"Location: http://127.0.0.1:{r['port']}/collector/v1")),
    # What an interim answer says is not about the answer.
    "interim_misleads": lambda c, n, r: c.sendall(
        b"HTTP/1.1 103 Early Hints\r\nRetry-After: 3600\r\n\r\n" +
        first_then(n, LOADING, STREAM_HEAD + STREAM)),
    "interim": lambda c, n, r: c.sendall(
        b"HTTP/1.1 103 Early Hints\r\nContent-Type: text/html\r\n\r\n" + STREAM_HEAD + STREAM),
    # Servers that know not every member of a request.
    "wants_max_completion_tokens": lambda c, n, r: c.sendall(
        STREAM_HEAD + STREAM if "max_completion_tokens" in r["body"] else
        whole(400, {"error": {
            "message": "Unsupported parameter: 'max_tokens' is not supported with this model. "
                       "Use 'max_completion_tokens' instead.",
            "type": "invalid_request_error", "param": "max_tokens",
            "code": "unsupported_parameter"}})),
    "knows_few_members": lambda c, n, r: c.sendall(next(
        (whole(422, {"detail": [{"type": "extra_forbidden", "loc": ["body", name],
                                 "msg": "Extra inputs are not permitted"}]})
         for name in ("seed", "stream_options", "temperature") if name in r["body"]),
        STREAM_HEAD + STREAM)),
}


def models(scenario):
    if scenario in ("no_models", "hang"):
        return None
    names = [{"id": name, "object": "model"} for name in ("tiny", "other")]
    return whole(200, {"object": "list", "data": names})


def read_request(connection):
    data = b""
    while b"\r\n\r\n" not in data:
        more = connection.recv(65536)
        if not more:
            return None
        data += more
        if data.startswith(TLS_HANDSHAKE):
            return {"method": "TLS", "path": "/tls_hello/", "headers": {}, "body": ""}
    text, body = data.split(b"\r\n\r\n", 1)
    first, *lines = text.decode("latin-1").split("\r\n")
    headers = {name.lower(): value.strip() for name, _, value in
               (line.partition(":") for line in lines)}
    method, path, _ = first.split(" ")
    if path.startswith("/closes_early/"):
        return None
    while len(body) < int(headers.get("content-length", 0)):
        body += connection.recv(65536)
    return {"method": method, "path": path, "headers": headers, "body": body.decode()}


def note(file, line):
    with open(FOLDER / file, "a", encoding="utf-8") as log:
        log.write(json.dumps(line) + "\n")


def serve(connection, port):
    request = None
    with connection:
        try:
            request = read_request(connection)
            if request is None:
                return
            scenario = request["path"].split("/")[1]
            answer = models(scenario) if request["method"] == "GET" else None
            request["time_s"] = time.monotonic()
            with LOCK:
                if answer is None:
                    SEEN[scenario] += 1
                count = SEEN[scenario]
                note("requests.jsonl", request)
            request["port"] = port
            if answer is not None:
                connection.sendall(answer)
            elif scenario in SCENARIOS:
                SCENARIOS[scenario](connection, count, request)
            connection.shutdown(socket.SHUT_WR)
        except OSError:
            pass  # the client had enough, as many of its tests want
        if request is None:
            return
        wait_until_closed(connection)
        with LOCK:
            note("closed.jsonl", {"path": request["path"]})


def accept_for_ever(listener, context):
    port = listener.getsockname()[1]
    while True:
        connection, _ = listener.accept()

        def serve_one(connection=connection):
            try:
                if context is not None:
                    connection = context.wrap_socket(connection, server_side=True)
            except OSError:
                return connection.close()
            return serve(connection, port)

        threading.Thread(target=serve_one, daemon=True).start()


def listen(context=None):
    listener = socket.create_server(("127.0.0.1", 0), backlog=64)
    threading.Thread(target=accept_for_ever, args=(listener, context), daemon=True).start()
    return listener.getsockname()[1]


def certificate(name, subject_alternative):
    """A context with a self-signed certificate that openssl makes, and the certificate's path."""
    paths = FOLDER / f"{name}.pem", FOLDER / f"{name}.key"
    subprocess.run(
        ["openssl", "req", "-x509", "-newkey", "ec", "-pkeyopt", "ec_paramgen_curve:prime256v1",
         "-nodes", "-days", "2", "-subj", "/CN=test", "-addext",
         f"subjectAltName={subject_alternative}", "-out", paths[0], "-keyout", paths[1]],
        check=True, stdin=subprocess.DEVNULL, capture_output=True)
    context = ssl.SSLContext(ssl.PROTOCOL_TLS_SERVER)
    context.load_cert_chain(*paths)
    return context, str(paths[0])


def expired_certificate(subject_alternative):
    """As certificate() makes, of 2020. Only `openssl ca` takes dates that are over."""
    paths = FOLDER / "expired.pem", FOLDER / "expired.key"
    configuration, request = FOLDER / "ca.cnf", FOLDER / "expired.csr"
    configuration.write_text(
        f"[ca]\ndefault_ca=own\n[own]\ndatabase={FOLDER}/issued.txt\nnew_certs_dir={FOLDER}\n"
        "rand_serial=yes\ndefault_md=sha256\npolicy=names\ncopy_extensions=copy\n"
        "[names]\ncommonName=supplied\n", encoding="utf-8")
    (FOLDER / "issued.txt").touch()
    for command in (
            ["req", "-newkey", "ec", "-pkeyopt", "ec_paramgen_curve:prime256v1", "-nodes", "-subj",
             "/CN=test", "-addext", f"subjectAltName={subject_alternative}", "-out", request,
             "-keyout", paths[1]],
            ["ca", "-batch", "-notext", "-selfsign", "-config", configuration, "-keyfile", paths[1],
             "-in", request, "-startdate", "20200101000000Z", "-enddate", "20200102000000Z", "-out",
             paths[0]]):
        subprocess.run(["openssl", *command], check=True, stdin=subprocess.DEVNULL,
                       capture_output=True)
    context = ssl.SSLContext(ssl.PROTOCOL_TLS_SERVER)
    context.load_cert_chain(*paths)
    return context, str(paths[0])


def main():
    own, own_path = certificate("own", "IP:127.0.0.1")
    expired, expired_path = expired_certificate("IP:127.0.0.1")
    foreign, foreign_path = certificate("foreign", "DNS:elsewhere.test")
    refusing = socket.socket()  # bound, so that nobody else listens there, and not listening
    refusing.bind(("127.0.0.1", 0))
    print(json.dumps({"port": listen(), "tls_port": listen(own), "tls_certificate": own_path,
                      "foreign_port": listen(foreign), "foreign_certificate": foreign_path,
                      "expired_port": listen(expired), "expired_certificate": expired_path,
                      "refusing_port": refusing.getsockname()[1]}), flush=True)
    sys.stdin.read()


if __name__ == "__main__":
    main()
