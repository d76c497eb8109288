// Reads an MCAP file with the reader of @mcap/core, and holds each message against the schema that the file has for it.
import { McapIndexedReader, TempBuffer } from "@mcap/core";
import { Ajv2020 } from "ajv/dist/2020.js";
import type { Field } from "../../shared/mcap/schemas";

export interface ReadMessage {
  readonly topic: string;
  readonly schema: string;
  readonly sequence: number;
  /** [us] since 1970. */
  readonly time: number;
  readonly published: number;
  readonly value: Readonly<Record<string, unknown>>;
}

export interface ReadFile {
  /** In the order of their times, as a reader shows them. */
  readonly messages: readonly ReadMessage[];
  readonly metadata: Readonly<Record<string, string>>;
  readonly attachments: ReadonlyMap<string, string>;
  /** Complete chunks of the file. */
  readonly chunks: number;
}

/** The schema, refusing fields that it does not name. */
export function strict(field: Field): object {
  const properties = field.properties && Object.fromEntries(Object.entries(field.properties).map(([name, each]) => [name, strict(each)]));
  return { ...field, ...(properties !== undefined && { properties, additionalProperties: false }), ...(field.items !== undefined && { items: strict(field.items) }) };
}

const kMicrosecond = 1000n;

/** Throws if the file, its checksums or a message of it is not as it should be. */
export async function readMcap(bytes: Uint8Array): Promise<ReadFile> {
  const reader = await McapIndexedReader.Initialize({ readable: new TempBuffer(bytes) });
  const decoder = new TextDecoder();
  const ajv = new Ajv2020();
  const schemas = new Map([...reader.schemasById].map(([id, { name, encoding, data }]) => {
    if (encoding !== "jsonschema") throw new Error(`${name} has the encoding ${encoding}`);
    return [id, { name, check: ajv.compile(strict(JSON.parse(decoder.decode(data)) as Field)) }] as const;
  }));
  const messages: ReadMessage[] = [];
  for await (const { channelId, sequence, logTime, publishTime, data } of reader.readMessages({ validateCrcs: true })) {
    const channel = reader.channelsById.get(channelId);
    const schema = schemas.get(channel?.schemaId ?? 0);
    if (channel === undefined || schema === undefined || channel.messageEncoding !== "json") throw new Error(`the file has no channel ${channelId} of JSON`);
    const value: unknown = JSON.parse(decoder.decode(data));
    if (!schema.check(value)) throw new Error(`${channel.topic}: ${ajv.errorsText(schema.check.errors)}`);
    messages.push({ topic: channel.topic, schema: schema.name, sequence, time: Number(logTime / kMicrosecond), published: Number(publishTime / kMicrosecond), value: value as ReadMessage["value"] });
  }
  let metadata: Readonly<Record<string, string>> = {};
  for await (const record of reader.readMetadata({ name: "race.run" })) metadata = Object.fromEntries(record.metadata);
  const attachments = new Map<string, string>();
  for await (const { name, data } of reader.readAttachments({ validateCrcs: true })) attachments.set(name, decoder.decode(data));
  return { messages, metadata, attachments, chunks: reader.chunkIndexes.length };
}

/** Messages of a topic, as they are in the file. */
export const onTopic = ({ messages }: ReadFile, topic: string): readonly ReadMessage[] => messages.filter((message) => message.topic === topic);
