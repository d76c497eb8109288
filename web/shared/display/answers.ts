// What an answer to a question of a display means, as far as its words tell.

/** Such answers end what is going on, instead of going on with it. */
const kWayOut = /^(abort|cancel|stop|quit|give up|end)\b/i;

/** Whether an answer looks like a way out: pages show it so that it is not taken for a way on. */
export const isWayOut = (answer: string): boolean => kWayOut.test(answer);
