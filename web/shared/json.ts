// JSON, as the client library has it.
export * from "../../api/typescript/src/json";
