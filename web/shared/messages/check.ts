// The check of what comes from outside, which is that of the client library.
export * from "../../../api/typescript/src/check";
