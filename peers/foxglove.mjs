// Foxglove's readers take a recorded episode: every message is decoded and encoded again, and goes
// through an MCAP file.
// debian: python3-rosbag
// npm: @foxglove/rosbag@0.4.1 @foxglove/wasm-lz4@1.0.2 @foxglove/rosmsg@5.0.5
// npm: @foxglove/rosmsg-serialization@2.0.4 @mcap/core@2.2.2
import {Bag} from '@foxglove/rosbag';
import {FileReader} from '@foxglove/rosbag/node.js';
import rosmsg from '@foxglove/rosmsg';
import serialization from '@foxglove/rosmsg-serialization';
import lz4 from '@foxglove/wasm-lz4';
import {McapIndexedReader, McapWriter, TempBuffer} from '@mcap/core';
import {createHash} from 'node:crypto';

import {episode, Peer, versionOf} from './peer.mjs';

const nanoseconds = ({sec, nsec}) => BigInt(sec) * 1000000000n + BigInt(nsec);

function take(hash, time, data) {
  const bytes = Buffer.alloc(8);
  bytes.writeBigUInt64LE(time);
  hash.update(bytes).update(data);
}

// The bag's messages in order of time: how many come back as they were, and an MCAP file of them.
async function readBag(file) {
  const bag = new Bag(new FileReader(file), {
    parse: false, decompress: {lz4: (buffer, size) => lz4(buffer, size)}});
  await bag.open();
  const buffer = new TempBuffer();
  const writer = new McapWriter({writable: buffer});
  await writer.start({profile: 'ros1', library: 'peers'});
  const found = {count: 0, same: 0, ordered: true, topics: new Set(), other: new Set(),
                 hash: createHash('sha256')};
  const coders = new Map();
  let before = 0n;
  for await (const {connectionId, topic, timestamp, data} of bag.messageIterator()) {
    const {type, messageDefinition: text, md5sum} = bag.connections.get(connectionId);
    if (!coders.has(connectionId)) {
      const definition = rosmsg.parse(text);
      const schemaId = await writer.registerSchema(
        {name: type, encoding: 'ros1msg', data: new TextEncoder().encode(text)});
      const channelId = await writer.registerChannel(
        {schemaId, topic, messageEncoding: 'ros1', metadata: new Map([['md5sum', md5sum]])});
      coders.set(connectionId, {channelId,
        reader: new serialization.MessageReader(definition),
        writer: new serialization.MessageWriter(definition)});
    }
    const coder = coders.get(connectionId), time = nanoseconds(timestamp);
    const again = coder.writer.writeMessage(coder.reader.readMessage(data));
    if (Buffer.compare(Buffer.from(again), Buffer.from(data)) === 0) found.same += 1;
    else found.other.add(type);
    await writer.addMessage({channelId: coder.channelId, sequence: found.count, logTime: time,
                             publishTime: time, data});
    take(found.hash, time, data);
    found.count += 1;
    found.ordered = found.ordered && time >= before;
    found.topics.add(topic);
    before = time;
  }
  await writer.end();
  return {...found, mcap: buffer};
}

const peer = new Peer("Foxglove's readers", `@foxglove/rosbag ${versionOf('@foxglove/rosbag')}`,
                      "an episode's bag (LZ4)", 'give `decompress` for lz4 (`@foxglove/wasm-lz4`)');
await lz4.isLoaded;
const {file, count} = episode();
const found = await readBag(file);
peer.check('messages', found.count === count && found.ordered,
           `${found.count} of ${count} of ${found.topics.size} topics, in order of time`);
peer.check('decoded and encoded again', found.same === count,
           `${found.same} the same bytes${[' ', ...found.other].join(' ').trimEnd()}`);
const reader = await McapIndexedReader.Initialize({readable: found.mcap});
const hash = createHash('sha256');
let kept = 0;
for await (const message of reader.readMessages()) {
  take(hash, message.logTime, message.data);
  kept += 1;
}
peer.check('through @mcap/core ' + versionOf('@mcap/core'),
           hash.digest('hex') === found.hash.digest('hex'), `${kept} messages, bytes and times the same`);
peer.finish();
