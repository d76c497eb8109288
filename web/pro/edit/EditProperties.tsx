// Right of the document that is edited: what is selected.
import type { ModelTree } from "../../shared/model/modelTree";
import { PropertiesPanel } from "../panels/PropertiesPanel";

export const EditProperties = ({ tree }: { readonly tree: ModelTree | undefined }) => <PropertiesPanel tree={tree} />;
