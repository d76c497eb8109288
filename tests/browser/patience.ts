// How long a test waits for what comes at once, unless the machine has much to do.
/** [ms] */
export const kPatience = 60_000;
export const kSoon = { timeout: kPatience };
