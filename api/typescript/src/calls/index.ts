// All routes of the server, a function for each: what it sends and answers. Made by api/python/generate/main.py.
export * from "./accounts.js";
export * from "./backups.js";
export * from "./cell.js";
export * from "./control.js";
export * from "./cores.js";
export * from "./documents.js";
export * from "./me.js";
export * from "./pair.js";
export * from "./proposals.js";
export * from "./queue.js";
export * from "./runs.js";
export * from "./server.js";
export * from "./services.js";
export * from "./stop.js";

export const kStreamPath = "/api/v1/stream";
