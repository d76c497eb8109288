// The stream of the client library.
export * from "../../api/typescript/src/stream/stream";
