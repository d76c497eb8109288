// What Enter does in a field of a row that has nothing to commit: it adds the next row.
import { createContext, useContext } from "react";

export const RowEnter = createContext<(() => void) | undefined>(undefined);

export const useRowEnter = (): (() => void) | undefined => useContext(RowEnter);
