// Messages of the stream, as the client library reads them.
export * from "../../../api/typescript/src/stream/messages";
