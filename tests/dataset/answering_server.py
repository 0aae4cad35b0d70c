#!/usr/bin/python3
"""A chat server that gives the answers of a file, for the tests of the remote annotator.

Called as answering_server.py ANSWERS REQUESTS [PORT [LAST]]: ANSWERS is a JSON array, an element a
request: a text is streamed as a model's answer, a number is the status of an HTTP error. Or it is an
object, and a request gets the answer whose key a message of its user contains. A request that has no
answer is refused with 410. Each request's body is appended to REQUESTS as a line. PORT: 0 for any that
is free. After LAST answers it goes away at the next request, without a word. It prints its port and
ends when its standard input does, so that it never outlives the test that started it.
"""

import http.server
import json
import os
import sys
import threading

ANSWERS = json.load(open(sys.argv[1], encoding="utf-8"))
PORT = int(sys.argv[3]) if len(sys.argv) > 3 else 0
LAST = int(sys.argv[4]) if len(sys.argv) > 4 else None
LOCK = threading.Lock()
PIECE = 9  # letters of an answer that are sent at once


class Handler(http.server.BaseHTTPRequestHandler):
    served = 0

    def log_message(self, *arguments):
        pass

    def do_GET(self):
        self.send(200, "application/json", json.dumps({"object": "list", "data": [
            {"id": "scribe", "object": "model"}]}))

    def do_POST(self):
        body = self.rfile.read(int(self.headers["Content-Length"])).decode()
        with LOCK:
            number = Handler.served
            if number == LAST:
                os._exit(0)
            Handler.served += 1
            with open(sys.argv[2], "a", encoding="utf-8") as log:
                log.write(body + "\n")
        answer = self.answer_to(json.loads(body), number)
        if isinstance(answer, int):
            return self.send(answer, "application/json",
                             json.dumps({"error": {"message": "not this time"}}))
        events = [{"role": "assistant", "content": ""}]
        events += [{"content": answer[i:i + PIECE]} for i in range(0, len(answer), PIECE)]
        lines = [self.event(delta, None) for delta in events] + [self.event({}, "stop")]
        self.send(200, "text/event-stream", "".join(lines) + "data: [DONE]\n\n")

    @staticmethod
    def answer_to(request, number):
        if isinstance(ANSWERS, list):
            return ANSWERS[number] if number < len(ANSWERS) else 410
        asked = [message["content"] for message in request["messages"] if message["role"] == "user"]
        return next((answer for key, answer in ANSWERS.items() if any(key in text for text in asked)), 410)

    @staticmethod
    def event(delta, finish_reason):
        choice = {"index": 0, "delta": delta, "finish_reason": finish_reason}
        return "data: " + json.dumps({"object": "chat.completion.chunk", "model": "scribe",
                                      "choices": [choice]}) + "\n\n"

    def send(self, status, kind, text):
        data = text.encode()
        self.send_response(status)
        self.send_header("Content-Type", kind)
        self.send_header("Content-Length", str(len(data)))
        self.end_headers()
        self.wfile.write(data)


server = http.server.ThreadingHTTPServer(("127.0.0.1", PORT), Handler)
threading.Thread(target=server.serve_forever, daemon=True).start()
print(server.server_address[1], flush=True)
sys.stdin.read()
