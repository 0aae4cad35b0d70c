// What real llama.cpp makes of a model file: reads one JSON value a line from standard input and
// answers each with one line.
//   {"text": "..."}                   its tokens, without any that control
//   {"tokens": [...], "count": n}     the n tokens that follow, each the likeliest
// Usage: node llama_answers.mjs MODEL.gguf
import { createRequire } from "node:module";
import { createInterface } from "node:readline";
import { pathToFileURL } from "node:url";

// The package lies where the tests were built, not beside this file.
const require = createRequire(process.cwd() + "/");
const { getLlama } = await import(pathToFileURL(require.resolve("node-llama-cpp")).href);

const llama = await getLlama({ gpu: false, build: "never", maxThreads: 1, logLevel: "error" });
const model = await llama.loadModel({ modelPath: process.argv[2] });
const context = await model.createContext({
  contextSize: 2048, sequences: 1, threads: 1, flashAttention: false,
  experimentalKvCacheKeyType: "F32", experimentalKvCacheValueType: "F32",
});
const sequence = context.getSequence();

for await (const line of createInterface({ input: process.stdin })) {
  const asked = JSON.parse(line);
  if (asked.text !== undefined) {
    console.log(JSON.stringify(model.tokenize(asked.text, false)));
    continue;
  }
  await sequence.clearHistory();
  const answer = [];
  const evaluated = sequence.evaluate(asked.tokens, { temperature: 0, yieldEogToken: true });
  for await (const token of evaluated) {
    answer.push(token);
    if (answer.length === asked.count) break;
  }
  console.log(JSON.stringify(answer));
}
process.exit(0);
