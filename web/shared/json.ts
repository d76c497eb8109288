/** Any JSON value, as it stands in results, parameters and event data. */
export type JsonValue = null | boolean | number | string | readonly JsonValue[] | { readonly [key: string]: JsonValue };
