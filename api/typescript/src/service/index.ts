// Services of one's own, for Node 18 or later: a class with fields that are operations, which tasks call as `svc.KEY.OPERATION(...)`.
export { run, serve, type RunOptions, type ServeOptions } from "./command.js";
export type { ServiceSocketConstructor } from "./connection.js";
export { DeclarationError } from "./declaration.js";
export { operation, type ArgumentsOf, type DeclaredParameters, type Operation, type OperationOptions, type ParameterOptions, type RunningCall, type Work } from "./operation.js";
export { Service, ServiceFailure, Stopped } from "./service.js";
