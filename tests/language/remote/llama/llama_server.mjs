// Real llama.cpp behind the HTTP interface of its own server, as far as LatticeWorld's tests need
// it: GET /health, GET /v1/models, POST /v1/chat/completions with a GBNF grammar or a JSON schema,
// whole or streamed. Prints "listening on http://127.0.0.1:PORT" once it can be asked.
// Usage: node llama_server.mjs MODEL.gguf [PORT]
// With LLAMA_RECORD=FILE in the environment every exchange is appended there, a JSON value a line.
import { appendFileSync } from "node:fs";
import { createServer } from "node:http";
import { createRequire } from "node:module";
import { basename } from "node:path";
import { pathToFileURL } from "node:url";

// The package lies where the tests were built, not beside this file.
const require = createRequire(process.cwd() + "/");
const { getLlama, LlamaCompletion } = await import(
  pathToFileURL(require.resolve("node-llama-cpp")).href
);

const [modelPath, port = "0"] = process.argv.slice(2);
const llama = await getLlama({ gpu: false, build: "never", maxThreads: 1, logLevel: "error" });
const model = await llama.loadModel({ modelPath });
const context = await model.createContext({
  contextSize: 32768, sequences: 1, threads: 1, flashAttention: false,
});
const sequence = context.getSequence();
const completion = new LlamaCompletion({ contextSequence: sequence });
const name = basename(modelPath, ".gguf");

async function grammarOf(body) {
  const format = body.response_format ?? {};
  const schema = body.json_schema ?? format.json_schema?.schema ?? format.schema;
  if (body.grammar) return llama.createGrammar({ grammar: body.grammar });
  if (schema) return llama.createGrammarForJsonSchema(schema);
  return undefined;
}

const textOf = (content) =>
  typeof content === "string" ? content : content.map((part) => part.text ?? "").join("");

let busy = Promise.resolve(); // one sequence: answers queue

async function answer(body, signal, onText) {
  const prompt = body.messages.map((one) => `${one.role}: ${textOf(one.content)}\n`).join("");
  await sequence.clearHistory();
  const tokens = model.tokenize(prompt + "assistant: ");
  let count = 0;
  const { response, metadata } = await completion.generateCompletionWithMeta(tokens, {
    grammar: await grammarOf(body),
    maxTokens: body.max_tokens ?? 1024,
    temperature: body.temperature ?? 0.8,
    seed: (body.seed ?? 1) % 2 ** 32,
    signal, stopOnAbortSignal: true,
    onTextChunk: onText,
    onToken: (some) => (count += some.length),
  });
  return {
    response,
    reason: metadata.stopReason === "maxTokens" ? "length" : "stop",
    usage: { prompt_tokens: tokens.length, completion_tokens: count,
             total_tokens: tokens.length + count },
  };
}

function send(response, status, value) {
  response.writeHead(status, { "Content-Type": "application/json" });
  response.end(JSON.stringify(value));
}

async function complete(body, response) {
  const gone = new AbortController();
  response.on("close", () => gone.abort());
  const head = { id: "chatcmpl-0", created: 0, model: name };
  const events = [];
  const event = (value) => {
    events.push(`data: ${JSON.stringify(value)}\n\n`);
    response.write(events.at(-1));
  };
  const chunk = (delta, reason = null) => event({
    ...head, object: "chat.completion.chunk",
    choices: [{ index: 0, delta, finish_reason: reason }],
  });
  if (!body.stream) {
    const { response: content, reason, usage } = await answer(body, gone.signal);
    return send(response, 200, {
      ...head, object: "chat.completion", usage,
      choices: [{ index: 0, message: { role: "assistant", content }, finish_reason: reason }],
    });
  }
  await grammarOf(body); // refused before the stream begins
  response.writeHead(200, { "Content-Type": "text/event-stream" });
  chunk({ role: "assistant" });
  const said = await answer(body, gone.signal, (content) => chunk({ content }));
  const { reason, usage } = said;
  chunk({}, reason);
  if (body.stream_options?.include_usage) {
    event({ ...head, object: "chat.completion.chunk", choices: [], usage });
  }
  if (process.env.LLAMA_RECORD) {
    const record = { request: body, events, answer: said.response };
    appendFileSync(process.env.LLAMA_RECORD, JSON.stringify(record) + "\n");
  }
  response.end("data: [DONE]\n\n");
}

const server = createServer(async (request, response) => {
  const refuse = (code, type, message) => send(response, code, { error: { code, message, type } });
  if (request.url === "/health") return send(response, 200, { status: "ok" });
  if (request.url === "/v1/models") {
    return send(response, 200, { object: "list", data: [{ id: name, object: "model" }] });
  }
  if (request.url !== "/v1/chat/completions") return refuse(404, "not_found_error", "no such path");
  let text = "";
  for await (const piece of request) text += piece;
  const turn = busy.then(() => complete(JSON.parse(text), response));
  busy = turn.catch((error) => {
    if (response.headersSent) return response.destroy();
    refuse(400, "invalid_request_error", String(error.message ?? error));
  });
});
server.listen(Number(port), "127.0.0.1", () =>
  console.log(`listening on http://127.0.0.1:${server.address().port}`));
