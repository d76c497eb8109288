// Writes messages as an MCAP file, in chunks, which leave the memory of the page for that of the browser's blobs as they are complete.
import { McapWriter, type IWritable } from "@mcap/core";
import type { McapChannel, McapMessage } from "./message";
import { kSchemas, type SchemaName } from "./schemas";

/** A file is not larger [byte]. */
export const kMostBytes = 512 * 1024 * 1024;
const kMegabyte = 1024 * 1024;
const kMicrosecond = 1000n;

/** What the file has besides its messages. */
export interface About {
  /** Of the record of metadata `race.run`. */
  readonly metadata: Readonly<Record<string, string>>;
  readonly attachments: readonly Attachment[];
}

export interface Attachment {
  readonly name: string;
  readonly mediaType: string;
  readonly text: string;
  /** [us] since 1970, UTC. */
  readonly time: number;
}

class BlobWritable implements IWritable {
  private readonly parts: Blob[] = [];
  private size = 0;

  constructor(private readonly most: number) {}

  /** The writer uses its buffer again: it is copied before this returns. */
  write(buffer: Uint8Array): Promise<void> {
    if (this.size + buffer.byteLength > this.most) return Promise.reject(new Error(`The file would be larger than ${Math.floor(this.most / kMegabyte)} MiB.`));
    this.parts.push(new Blob([new Uint8Array(buffer)]));
    this.size += buffer.byteLength;
    return Promise.resolve();
  }

  position(): bigint {
    return BigInt(this.size);
  }

  blob(): Blob {
    return new Blob(this.parts, { type: "application/octet-stream" });
  }
}

/** The channels of a file, which are told to it as they are first used. */
class Channels {
  private readonly schemas = new Map<SchemaName, number>();
  private readonly channels = new Map<string, { readonly id: number; next: number }>();

  constructor(
    private readonly writer: McapWriter,
    private readonly encoder: TextEncoder,
  ) {}

  /** The channel, and the number of its next message, from 0. */
  async next({ topic, schema }: McapChannel): Promise<{ readonly id: number; readonly sequence: number }> {
    const known = this.channels.get(topic);
    if (known !== undefined) return { id: known.id, sequence: known.next++ };
    const id = await this.writer.registerChannel({ schemaId: await this.schemaOf(schema), topic, messageEncoding: "json", metadata: new Map() });
    this.channels.set(topic, { id, next: 1 });
    return { id, sequence: 0 };
  }

  private async schemaOf(name: SchemaName): Promise<number> {
    const known = this.schemas.get(name);
    if (known !== undefined) return known;
    const id = await this.writer.registerSchema({ name, encoding: "jsonschema", data: this.encoder.encode(JSON.stringify(kSchemas[name])) });
    this.schemas.set(name, id);
    return id;
  }
}

/** Throws what a source throws, and if the file would have more than `most` bytes. */
export async function writeMcap(messages: AsyncIterable<McapMessage>, { metadata, attachments }: About, most = kMostBytes): Promise<Blob> {
  const writable = new BlobWritable(most);
  const writer = new McapWriter({ writable, chunkSize: kMegabyte });
  const encoder = new TextEncoder();
  const channels = new Channels(writer, encoder);
  await writer.start();
  await writer.addMetadata({ name: "race.run", metadata: new Map(Object.entries(metadata)) });
  for (const { name, mediaType, text, time } of attachments) {
    const created = BigInt(time) * kMicrosecond;
    await writer.addAttachment({ name, mediaType, data: encoder.encode(text), logTime: created, createTime: created });
  }
  for await (const { channel, time, published = time, value } of messages) {
    const { id, sequence } = await channels.next(channel);
    await writer.addMessage({ channelId: id, sequence, logTime: BigInt(time) * kMicrosecond, publishTime: BigInt(published) * kMicrosecond, data: encoder.encode(JSON.stringify(value)) });
  }
  await writer.end();
  return writable.blob();
}
