// Ids that nobody else makes, as the client library makes them.
export * from "../../api/typescript/src/newId";
