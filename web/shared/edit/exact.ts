// The numbers of JSON as they were written; they are of the client library, which sends and reads them.
export * from "../../../api/typescript/src/exact";
