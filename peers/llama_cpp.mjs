// llama.cpp, by way of node-llama-cpp, loads the models that are shipped: its tokens and likeliest
// continuations beside those of LatticeWorld's own decoder, and a layout under a grammar.
// npm: node-llama-cpp@3.22.1 @node-llama-cpp/linux-x64@3.22.1
import {execFileSync} from 'node:child_process';
import fs from 'node:fs';
import path from 'node:path';

import {getLlama, JinjaTemplateChatWrapper, LlamaGrammar, LlamaGrammarEvaluationState} from 'node-llama-cpp';

import {Peer, versionOf} from './peer.mjs';

const PROGRAM = process.env.PEER_PROGRAM, FOLDER = process.env.PEER_FOLDER;
const MODELS = path.join(process.env.PYTHONPATH.split(':')[0], '..', '..', 'models');
const PROMPTS = 8, NEXT = 40;
const GRAMMAR = 'root ::= line{31} row\nline ::= row "\\n"\nrow ::= [ABDFGRSW]{32}\n';

// What LatticeWorld's decoder answers to lines of questions about a model file.
function ours(model, questions) {
  const lines = questions.map((question) => JSON.stringify(question) + '\n').join('');
  const answers = execFileSync(path.join(path.dirname(PROGRAM), 'local_answers'), [model],
                               {input: lines, encoding: 'utf8'});
  return answers.trim().split('\n').map((line) => JSON.parse(line));
}

function conversations(kind) {
  const folder = path.join(FOLDER, `data_${kind}`);
  if (!fs.existsSync(folder)) {
    execFileSync(PROGRAM, ['dataset', '--generate', String(PROMPTS), '--seed', '3', `--${kind}`,
      '--no-images', '--prompts', 'short', '--relief-share', '0', '--split', '1,0', '--out', folder],
                 {stdio: 'ignore'});
  }
  return fs.readFileSync(path.join(folder, kind, 'train.jsonl'), 'utf8').trim().split('\n')
      .map((line) => JSON.parse(line).messages);
}

const begun = (messages) => messages.filter(({role}) => role === 'user')
    .map(({content}) => `user\n${content}`).join('');

// Tokens of a user's turn and of the beginning of the answer, as training lays them out.
function turn(model, text) {
  return [1, 2, ...model.tokenize(text, false), 3, ...model.tokenize('\n', false),
          2, ...model.tokenize('assistant\n', false)];
}

async function compare(peer, llama, name, kind) {
  const file = path.join(MODELS, name);
  const model = await llama.loadModel({modelPath: file});
  const texts = conversations(kind).flatMap((messages) => messages.map(({content}) => content));
  const wanted = ours(file, texts.map((text) => ({text})));
  const same = texts.filter((text, i) =>
      JSON.stringify([...model.tokenize(text, false)]) === JSON.stringify(wanted[i])).length;
  peer.check(`${name}, tokens`, same === texts.length, `${same} of ${texts.length} texts the same`);

  const context = await model.createContext({contextSize: 2048, sequences: 1, threads: 1,
    flashAttention: false, experimentalKvCacheKeyType: 'F32', experimentalKvCacheValueType: 'F32'});
  const sequence = context.getSequence();
  const turns = conversations(kind).map((messages) => turn(model, begun(messages)));
  const next = ours(file, turns.map((tokens) => ({tokens, count: NEXT})));
  let agreed = 0, all = 0;
  for (let i = 0; i < turns.length; ++i) {
    await sequence.clearHistory();
    const answer = [];
    for await (const token of sequence.evaluate(turns[i], {temperature: 0, yieldEogToken: true})) {
      answer.push(token);
      if (answer.length === next[i].length) break;
    }
    const until = answer.findIndex((token, k) => token !== next[i][k]);
    agreed += until < 0 ? answer.length : until;
    all += next[i].length;
  }
  peer.check(`${name}, likeliest tokens`, agreed > 0.9 * all,
             `${agreed} of ${all} the same until the first that differs`);
  checkTemplate(peer, model, name, kind);
  await context.dispose();
  return model;
}

// A conversation by the file's own template: training lays it out without the system message.
function checkTemplate(peer, model, name, kind) {
  const template = model.fileInfo.metadata.tokenizer.chat_template;
  const user = conversations(kind)[0].find(({role}) => role === 'user').content;
  const wanted = JSON.stringify(turn(model, `user\n${user}`));
  const laidOut = (...before) => {
    const wrapper = new JinjaTemplateChatWrapper(
        {template, functionCallMessageTemplate: 'noJinja'});
    const {contextText} = wrapper.generateContextState({chatHistory: [
      ...before, {type: 'user', text: user}, {type: 'model', response: []}]});
    return JSON.stringify([...contextText.tokenize(model.tokenizer)]) === wanted;
  };
  const found = [laidOut(), laidOut({type: 'system', text: 'You draw maps.'})];
  const words = found.map((same) => same ? 'as in training' : 'otherwise');
  peer.check(`${name}, the template in the file`, found[0] && !found[1],
             `${words[0]}; with a system message ${words[1]} (it is put into the user's turn)`);
}

async function drawUnderGrammar(peer, llama, model) {
  const context = await model.createContext({contextSize: 2048, sequences: 1, threads: 1});
  const sequence = context.getSequence();
  const grammar = new LlamaGrammar(llama, {grammar: GRAMMAR});
  const state = new LlamaGrammarEvaluationState({model, grammar});
  const tokens = turn(model, 'user\nA lake in the north.');
  const answer = [];
  for await (const token of sequence.evaluate(tokens, {temperature: 0, grammarEvaluationState: state})) {
    answer.push(token);
    if (answer.length > 1200) break;
  }
  const rows = model.detokenize(answer).split('\n');
  peer.check('a layout under a grammar', rows.length === 32 && rows.every((row) => /^[A-Z]{32}$/.test(row)),
             `${rows.length} rows, water in ${rows.filter((row) => row.includes('W')).length}`);
  await context.dispose();
}

const llama = await getLlama({gpu: false, build: 'never', maxThreads: 1, logLevel: 'error'});
const peer = new Peer('llama.cpp', `node-llama-cpp ${versionOf('node-llama-cpp')}`, '`models/*.gguf`',
                      'give no system message; `guidance` is not applied, so that less is kept of what was ' +
                      'asked (models/README.md)');
const layouts = await compare(peer, llama, 'layouts.gguf', 'layout');
await compare(peer, llama, 'environments.gguf', 'environment');
await drawUnderGrammar(peer, llama, layouts);
let refused = '';
await llama.loadModel({modelPath: path.join(MODELS, 'reader.gguf')}).catch((error) => {
  refused = String(error.message);
});
peer.check('reader.gguf, which is adapters', refused, `refused: ${refused.slice(0, 80)}`);
peer.finish();
