// Routes of api/openapi.yaml: cell. Made by api/python/generate/main.py. The request filter may also refuse each.
import { segment, type Body, type Call } from "../call.js";
import type { CellReset, Person, PersonCommand, Scene } from "../generated/messages.js";
import * as schema from "../generated/validators.js";

/**
 * What the cell looks like; its motion is on the channel cell/pose.
 *
 * 404: There is no world here: the server has no cell (`not_found`).
 *
 * 503: The cell is a separate process that is not connected or does not answer (`unavailable`). A command that it has not begun
 * is dropped; one that it has begun may be completed. Or two commands wait for it already.
 */
export const getCell = (): Call<Scene> => ({ method: "GET", path: "/api/v1/cell", answer: schema.scene });

/**
 * What the hands at the cell hold, and which parts were taken away.
 *
 * 404: There is no world here: the server has no cell (`not_found`).
 *
 * 503: The cell is a separate process that is not connected or does not answer (`unavailable`). A command that it has not begun
 * is dropped; one that it has begun may be completed. Or two commands wait for it already.
 */
export const getPerson = (): Call<Person> => ({ method: "GET", path: "/api/v1/cell/person", answer: schema.person });

/**
 * A person grabs, drags, releases or pushes a link of the robot or a part, by forces alone; or places a part or takes it away. A
 * hand that nobody drags, and whose target rests, lets go after `keep` seconds. Errors name the field.
 *
 * 400: The body is no JSON or out of its limits (`json`, `too_deep`), or a number is out of its range (`out_of_range`, with the
 * limits).
 *
 * 404: No such link or part, or no cell.
 *
 * 409: The part is taken away, would be inside another body, or the hand holds nothing.
 *
 * 422: The command does not fit its schema, or the body cannot be moved.
 *
 * 503: The cell is a separate process that is not connected or does not answer (`unavailable`). A command that it has not begun
 * is dropped; one that it has begun may be completed. Or two commands wait for it already.
 */
export const commandPerson = (body: Body<PersonCommand>): Call<Person> => ({
  method: "POST",
  path: "/api/v1/cell/person",
  body,
  answer: schema.person,
});

/**
 * The cell as it was at the start: parts and robot are where the scene says, at rest, and all hands let go; what waits for an
 * answer of the robot or the gripper is answered `unavailable`. The values of `database.json` become the only ones of the
 * database, unless the body keeps them. Refused while a run has begun and is not over, while the cell is stopped, and while
 * somebody else has its controls.
 *
 * raceControl: The secret of the message `taken` (control_message.json): who sends the request has the controls of the cell. 409
 * (`leased`): they have them no more.
 *
 * 404: There is no world here: the server has no cell (`not_found`).
 *
 * 409: A run is not over, which the message names; or the cell or the database is a process of its own, or the cell is being
 * reset already (`conflict`). Also `stopped`, and `leased`: somebody else has the controls.
 *
 * 422: The body does not fit its schema.
 *
 * 503: The cell is a separate process that is not connected or does not answer (`unavailable`). A command that it has not begun
 * is dropped; one that it has begun may be completed. Or two commands wait for it already.
 */
export const resetCell = (body?: Body<CellReset>, options: { readonly raceControl?: string | undefined } = {}): Call<Person> => ({
  method: "POST",
  path: "/api/v1/cell/reset",
  headers: { "Race-Control": options.raceControl },
  body,
  answer: schema.person,
});

/**
 * A URDF file that the scene names.
 *
 * file: Name of a file, as scene.json has it.
 *
 * 404: There is nothing of this name or number (`not_found`).
 *
 * 503: The cell is a separate process that is not connected or does not answer (`unavailable`). A command that it has not begun
 * is dropped; one that it has begun may be completed. Or two commands wait for it already.
 */
export const getCellFile = (file: string): Call<string> => ({
  method: "GET",
  path: `/api/v1/cell/${segment(file)}`,
  answer: "text",
});
